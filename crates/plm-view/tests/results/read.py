import ast, json, struct, sys, zipfile
path = sys.argv[1]
archive = zipfile.ZipFile(path)
assert archive.testzip() is None
head = json.loads(archive.read("plm.json"))
assert (head["format"], head["version"]) == ("plm results", 1)
def plain(name):
    data = archive.read(name)
    assert data[:8] == b"\x93NUMPY\x01\x00" and (10 + struct.unpack("<H", data[8:10])[0]) % 64 == 0
    length = 10 + struct.unpack("<H", data[8:10])[0]
    header = ast.literal_eval(data[10:length].decode("latin1"))
    assert header["descr"] == "<f8" and header["fortran_order"] is False
    numbers = data[length:]
    count = 1
    for n in header["shape"]: count *= n
    assert len(numbers) == 8 * count
    return header["shape"], numbers
try:
    import numpy
    arrays = numpy.load(path)
    def read(name):
        array = arrays[name[:-4]]
        assert array.dtype == numpy.float64
        return array.shape, array.tobytes()
    kind = "numpy " + numpy.__version__
except ImportError:
    read, kind = plain, "python"
print(kind)
for k, run in enumerate(head["runs"]):
    for name in ["time", "poses", "ground", "values"]:
        shape, numbers = read(f"{k}/{name}.npy")
        assert (tuple(shape), numbers) == (tuple(plain(f"{k}/{name}.npy")[0]), plain(f"{k}/{name}.npy")[1])
        print(name, list(shape), numbers.hex())
print(head["runs"][0]["mechanism"]["parts"][0]["frames"])
