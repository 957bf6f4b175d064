using System.Globalization;
using System.IO.Compression;
using System.Text;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A session of very many frames that share one image, and a packed road file that takes long to unpack.</summary>
public sealed class HugeSession : IDisposable
{
    private const int Frames = 20_000;
    private const int Megabytes = 1000;
    private readonly TemporaryFolder _folder = new();

    public HugeSession()
    {
        CliRun harvest = CliRun.Of(
            "harvest",
            "--frames",
            "1",
            "--seed",
            "5",
            "--size",
            "80x60",
            "--masks",
            "--no-report",
            "--out",
            Session
        );
        Assert.True(harvest.ExitCode == ExitCode.Done, harvest.Error);
        string labels = System.IO.Path.Combine(Session, "labels.jsonl");
        string line = File.ReadAllText(labels);
        Assert.StartsWith("{\"frame\":0,", line, StringComparison.Ordinal);
        using (StreamWriter more = File.AppendText(labels))
        {
            for (int frame = 1; frame < Frames; frame++)
            {
                more.Write(string.Create(CultureInfo.InvariantCulture, $"{{\"frame\":{frame},{line.AsSpan("{\"frame\":0,".Length)}"));
            }
        }

        string scene = System.IO.Path.Combine(Session, "scenes/00000000.json");
        for (int frame = 1; frame < Frames; frame++)
        {
            File.Copy(scene, System.IO.Path.Combine(Session, string.Create(CultureInfo.InvariantCulture, $"scenes/{frame:D8}.json")));
        }

        using var roads = new GZipStream(File.Create(Roads), CompressionLevel.Fastest);
        roads.Write(File.ReadAllBytes(System.IO.Path.Combine(Session, "scenes/roads.csv")));
        byte[] blank = Encoding.UTF8.GetBytes(string.Concat(Enumerable.Repeat(new string('\n', 64), 1 << 14)));
        for (int i = 0; i < Megabytes; i++)
        {
            roads.Write(blank);
        }
    }

    public string Path => _folder.Path;

    public string Session => _folder.PathOf("session");

    public string Roads => _folder.PathOf("roads.csv.gz");

    public void Dispose() => _folder.Dispose();
}
