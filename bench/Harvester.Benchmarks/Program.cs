using System.Globalization;
using BenchmarkDotNet.Running;
using Harvester.Benchmarks;
using Harvester.Benchmarks.Figures;
using Harvester.Benchmarks.Occlusion;
using Harvester.Benchmarks.PixelMaps;
using Harvester.Benchmarks.Scenarios;
using Harvester.Geometry.Cameras;

// pixel-maps and pixel-map-sweep compare figures that are no times, so they are no benchmarks of BenchmarkDotNet's.
if (args is ["pixel-maps" or "pixel-map-sweep", var width, var height, var seed, .. var rest])
{
    var size = new ImageSize(int.Parse(width, CultureInfo.InvariantCulture), int.Parse(height, CultureInfo.InvariantCulture));
    int firstSeed = int.Parse(seed, CultureInfo.InvariantCulture);
    if (args[0] == "pixel-maps")
    {
        PixelMapComparison.Run(size, firstSeed, rest.FirstOrDefault());
    }
    else
    {
        StrategySweep.Run(size, firstSeed);
    }

    return;
}

// occlusion compares fractions with the renderer's: density, frames of a street, first and last seed.
if (args is ["occlusion", var density, var ofStreet, var first, var last])
{
    OcclusionErrors.Run(
        double.Parse(density, CultureInfo.InvariantCulture),
        int.Parse(ofStreet, CultureInfo.InvariantCulture),
        int.Parse(first, CultureInfo.InvariantCulture),
        int.Parse(last, CultureInfo.InvariantCulture)
    );
    return;
}

// scenario-scores drives through scenarios: folder of the scenario files, first and last seed, and optionally a file of roads.
if (args is ["scenario-scores", var scenarios, var firstScore, var lastScore, .. var roads])
{
    ScenarioScores.Run(
        scenarios,
        int.Parse(firstScore, CultureInfo.InvariantCulture),
        int.Parse(lastScore, CultureInfo.InvariantCulture),
        roads.FirstOrDefault()
    );
    return;
}

// scenario-pictures draws scenarios from above: folder of the scenario files, folder to write to, and seed.
if (args is ["scenario-pictures", var drawn, var pictures, var pictureSeed])
{
    ScenarioPictures.Run(drawn, pictures, int.Parse(pictureSeed, CultureInfo.InvariantCulture));
    return;
}

// bridge-latency gives the greatest hundredth, which BenchmarkDotNet does not.
if (args is ["bridge-latency", var frames])
{
    BridgeLatency.Run(int.Parse(frames, CultureInfo.InvariantCulture));
    return;
}

// figures are those that bench/run puts beside the ones of other programs.
if (args is ["figures", var folder])
{
    FigureRun.Run(folder);
    return;
}

BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args);
