/** Texts that the bundler puts in. */
declare module "*.css" {
  const text: string;
  export default text;
}
