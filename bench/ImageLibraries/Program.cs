using System.Diagnostics;
using System.Globalization;
using Harvester.ImageLibraries;

if (args.Length == 0)
{
    Console.Error.WriteLine("Usage: ImageLibraries IMAGE...   (8-bit PNG or JPEG files; docs/decisions/0012 has the results)");
    return 2;
}

IImageLibrary[] libraries = [new OwnDecoders(), new ImageSharpLibrary(), new SkiaLibrary(), new StbLibrary()];
Console.WriteLine(
    "| library | file | decode, ms | pixels as ours | damaged: refused | other exception | differs unnoticed | > 1 s | > 1 GB |"
);
Console.WriteLine("|---|---|---|---|---|---|---|---|---|");
foreach (string path in args)
{
    byte[] file = File.ReadAllBytes(path);
    byte[] expected = libraries[0].Decode(file);
    foreach (IImageLibrary library in libraries)
    {
        double milliseconds = Median([.. Enumerable.Range(0, 60).Select(_ => TimeOf(() => library.Decode(file)))]);
        bool agrees = library.Decode(file).AsSpan().SequenceEqual(expected);
        DamageCount damage = Damage.Count(library, file, count: 1000, seed: 12);
        Console.WriteLine(
            string.Create(
                CultureInfo.InvariantCulture,
                $"| {library.Name} | {Path.GetExtension(path)} | {milliseconds:0.0} | {(agrees ? "yes" : "no")} | {damage.Refused} | "
                    + $"{damage.OtherExceptions} | {damage.Unnoticed} | {damage.Slow} | {damage.Large} |"
            )
        );
    }
}

return 0;

static double TimeOf(Action action)
{
    long started = Stopwatch.GetTimestamp();
    action();
    return Stopwatch.GetElapsedTime(started).TotalMilliseconds;
}

static double Median(double[] values)
{
    Array.Sort(values);
    return values[values.Length / 2];
}
