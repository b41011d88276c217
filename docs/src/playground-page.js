// The page of the playground beside the book, which `bash examples/playground/build.sh --book FOLDER` puts there and names here.
plmPlayground = null;
