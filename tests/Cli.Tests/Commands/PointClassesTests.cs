using System.IO.Compression;
using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Semantics;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Classes and instances of LiDAR points in nuScenes exports, and what validate finds in damaged ones.</summary>
public sealed class PointClassesTests(HarvestedRig harvested) : IClassFixture<HarvestedRig>, IDisposable
{
    private const int BytesPerPoint = 20;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Each point of the session by its class and object, against the bytes of the export by the formats' own rules.</summary>
    [Fact]
    public void Points_have_the_classes_and_objects_that_rays_met()
    {
        Export();
        string[] points = [.. Directory.EnumerateFiles(_folder.PathOf("out/samples/top")).Order(StringComparer.Ordinal)];
        string[] sweeps = [.. Directory.EnumerateFiles(Path.Combine(harvested.Session, "lidar", "top")).Order(StringComparer.Ordinal)];
        Assert.Equal(4, points.Length);
        Assert.Equal(sweeps.Length, points.Length);
        var seen = new SortedSet<int>();
        foreach ((string file, string sweep) in points.Zip(sweeps))
        {
            LidarPoint[] expected = LidarFile.Read(File.ReadAllBytes(sweep));
            byte[] classes = File.ReadAllBytes(SegmentsOf(file, "lidarseg", ".bin"));
            ushort[] panoptic = ArrayIn(SegmentsOf(file, "panoptic", ".npz"));
            Assert.Equal(new FileInfo(file).Length / BytesPerPoint, classes.Length);
            Assert.Equal((expected.Length, expected.Length), (classes.Length, panoptic.Length));
            for (int i = 0; i < expected.Length; i++)
            {
                int index = classes[i];
                seen.Add(index);
                Assert.Equal(index, panoptic[i] / 1000);
                Assert.Contains(index, IndexesOf(expected[i].Class));
                bool isThing = index is > 0 and < 24;
                Assert.Equal(
                    isThing && expected[i].Class != SemanticClass.Rider ? expected[i].ObjectId : panoptic[i] % 1000,
                    panoptic[i] % 1000
                );
                Assert.Equal(isThing, panoptic[i] % 1000 > 0);
            }
        }

        Assert.Contains(24, seen);
        Assert.Contains(seen, static index => index is > 0 and < 24);
    }

    [Fact]
    public void Each_table_has_a_record_for_the_points_of_a_sample()
    {
        Export();
        using JsonDocument data = JsonDocument.Parse(File.ReadAllText(_folder.PathOf("out/v1.0-gta/sample_data.json")));
        string[] expected =
        [
            .. data
                .RootElement.EnumerateArray()
                .Where(record => record.GetProperty("filename").GetString()!.Contains("samples/top/", StringComparison.Ordinal))
                .Select(record => record.GetProperty("token").GetString()!)
                .Order(StringComparer.Ordinal),
        ];
        foreach (string table in new[] { "lidarseg", "panoptic" })
        {
            using JsonDocument records = JsonDocument.Parse(File.ReadAllText(_folder.PathOf($"out/v1.0-gta/{table}.json")));
            Assert.Equal(
                expected,
                records
                    .RootElement.EnumerateArray()
                    .Select(record => record.GetProperty("token").GetString()!)
                    .Order(StringComparer.Ordinal)
            );
            Assert.All(
                records.RootElement.EnumerateArray(),
                record => Assert.True(File.Exists(_folder.PathOf("out/" + record.GetProperty("filename").GetString())))
            );
        }
    }

    [Theory]
    [InlineData("lidarseg", ".bin", "does not have a number for each of the")]
    [InlineData("panoptic", ".npz", "does not have a number for each of the")]
    public void Cut_off_file_is_found(string table, string extension, string problem)
    {
        Export();
        string file = FirstOf(table, extension);
        File.WriteAllBytes(file, File.ReadAllBytes(file)[..^2]);
        AssertFound(problem);
    }

    [Fact]
    public void Unknown_category_is_found()
    {
        Export();
        string file = FirstOf("lidarseg", ".bin");
        byte[] bytes = File.ReadAllBytes(file);
        bytes[3] = 13;
        File.WriteAllBytes(file, bytes);
        AssertFound("has the category 13, which category.json does not have.");
    }

    private void Export() => CliRun.Of("export", harvested.Session, "--format", "nuscenes", "--out", _folder.PathOf("out")).AssertDone();

    private void AssertFound(string problem)
    {
        File.Delete(_folder.PathOf("out/manifest.jsonl"));
        CliRun run = CliRun.Of("validate", _folder.PathOf("out"));
        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(problem, run.Out, StringComparison.Ordinal);
    }

    private string FirstOf(string table, string extension) =>
        Directory.EnumerateFiles(_folder.PathOf($"out/{table}/v1.0-gta"), "*" + extension).Order(StringComparer.Ordinal).First();

    private string SegmentsOf(string points, string table, string extension) =>
        _folder.PathOf(
            $"out/{table}/v1.0-gta/{Path.GetFileName(points).Replace(".pcd.bin", "", StringComparison.Ordinal)}_{table}{extension}"
        );

    /// <summary>The array data.npy: magic and version, 8 bytes; length of the head, 2 bytes; the head; little-endian numbers.</summary>
    private static ushort[] ArrayIn(string file)
    {
        using ZipArchive archive = ZipFile.OpenRead(file);
        using Stream entry = archive.GetEntry("data.npy")!.Open();
        using var memory = new MemoryStream();
        entry.CopyTo(memory);
        byte[] bytes = memory.ToArray();
        int head = 10 + BitConverter.ToUInt16(bytes, 8);
        Assert.Equal(0, head % 64);
        Assert.Contains(
            "'descr': '<u2', 'fortran_order': False",
            System.Text.Encoding.ASCII.GetString(bytes, 10, head - 10),
            StringComparison.Ordinal
        );
        ushort[] values = new ushort[(bytes.Length - head) / 2];
        Buffer.BlockCopy(bytes, head, values, 0, 2 * values.Length);
        return values;
    }

    /// <summary>The indexes of nuScenes-lidarseg that a class of the session may have.</summary>
    private static int[] IndexesOf(SemanticClass kind) =>
        kind switch
        {
            SemanticClass.Road or SemanticClass.LaneMarking => [24],
            SemanticClass.Pavement => [26],
            SemanticClass.Terrain => [27],
            SemanticClass.Building or SemanticClass.Pole or SemanticClass.Fence or SemanticClass.Sign or SemanticClass.TrafficLight => [28],
            SemanticClass.Other => [29],
            SemanticClass.Vegetation => [30],
            SemanticClass.Car => [17, 19, 20],
            SemanticClass.Truck => [19, 20, 23],
            SemanticClass.Bus => [16],
            SemanticClass.Motorcycle => [21],
            SemanticClass.Bicycle => [14],
            SemanticClass.Trailer => [22],
            SemanticClass.Pedestrian => [2],
            SemanticClass.Rider => [0, 14, 21],
            _ => [0],
        };
}
