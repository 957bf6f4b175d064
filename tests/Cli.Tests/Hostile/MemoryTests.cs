using System.Diagnostics;
using System.IO.Compression;
using System.Text;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Small files that unpack to large ones, and endless lines, are refused by a process whose heap is limited to 1 GB.</summary>
[Trait("Category", "Heavy")]
public sealed class MemoryTests : IDisposable
{
    private const int Megabyte = 1 << 20;
    private const string HeapLimit = "0x40000000";
    private static readonly string Program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("harvester roads,1\n", "1")]
    [InlineData("vnod\n", "1")]
    [InlineData("[{\"AreaId\": 1, \"Nodes\": [], \"x\": \"", "a")]
    [InlineData("[{\"AreaId\": 1, \"Nodes\": [", "{},")]
    [InlineData("<scene><objects><object class=\"vehiclenode\" guid=\"", "a")]
    [InlineData("<scene><objects><object class=\"vehiclelink\">", "<a/>")]
    [InlineData("<NodeDictionary>", "<a/>")]
    public void Packed_bomb_of_900_MB_is_refused(string start, string again)
    {
        string file = _folder.PathOf("roads.gz");
        using (var gzip = new GZipStream(File.Create(file), CompressionLevel.Fastest))
        {
            gzip.Write(Encoding.UTF8.GetBytes(start));
            byte[] block = Encoding.UTF8.GetBytes(string.Concat(Enumerable.Repeat(again, Megabyte / again.Length)));
            for (int i = 0; i < 900; i++)
            {
                gzip.Write(block);
            }
        }

        AssertRefused("roads", "info", file);
    }

    [Fact]
    public void Line_of_100_MB_of_points_is_refused()
    {
        string file = _folder.PathOf("points.csv");
        using (FileStream points = File.Create(file))
        {
            byte[] block = Encoding.UTF8.GetBytes(string.Concat(Enumerable.Repeat("1,", Megabyte / 2)));
            for (int i = 0; i < 100; i++)
            {
                points.Write(block);
            }
        }

        AssertRefused("project", "--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50", "--size", "80x60", "--points", file);
    }

    [Fact]
    public void Label_line_of_900_MB_is_refused()
    {
        _folder.File("session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 } }""");
        using (FileStream labels = File.Create(_folder.PathOf("labels.jsonl")))
        {
            byte[] block = new byte[Megabyte];
            Array.Fill(block, (byte)'[');
            for (int i = 0; i < 900; i++)
            {
                labels.Write(block);
            }

            labels.Write("\n"u8);
        }

        AssertRefused("stats", _folder.Path);
    }

    private static void AssertRefused(params string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet", [Program, .. arguments]) { RedirectStandardError = true, RedirectStandardOutput = true };
        start.Environment["DOTNET_GCHeapHardLimit"] = HeapLimit;
        using Process process = Process.Start(start)!;
        process.StandardOutput.ReadToEnd();
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();

        Assert.True(process.ExitCode == ExitCode.BadData, $"{process.ExitCode}: {error}");
        Assert.Equal(1, error.Count(character => character == '\n'));
    }
}
