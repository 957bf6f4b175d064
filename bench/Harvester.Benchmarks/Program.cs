using System.Globalization;
using BenchmarkDotNet.Running;
using Harvester.Benchmarks;
using Harvester.Benchmarks.PixelMaps;
using Harvester.Geometry.Cameras;

// pixel-maps compares figures that are no times, so it is no benchmark of BenchmarkDotNet's.
if (args is ["pixel-maps", var width, var height, var seed, .. var rest])
{
    var size = new ImageSize(int.Parse(width, CultureInfo.InvariantCulture), int.Parse(height, CultureInfo.InvariantCulture));
    PixelMapComparison.Run(size, int.Parse(seed, CultureInfo.InvariantCulture), rest.FirstOrDefault());
    return;
}

// bridge-latency gives the greatest hundredth, which BenchmarkDotNet does not.
if (args is ["bridge-latency", var frames])
{
    BridgeLatency.Run(int.Parse(frames, CultureInfo.InvariantCulture));
    return;
}

BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args);
