using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The same small harvest in every image format, made once for all tests that read them.</summary>
public sealed class HarvestedFormats : IDisposable
{
    public const int Frames = 4;
    private readonly TemporaryFolder _folder = new();

    public HarvestedFormats()
    {
        foreach (string format in (string[])["png", "bmp", "jpg"])
        {
            CliRun run = CliRun.Of(
                "harvest",
                "--out",
                SessionOf(format),
                "--frames",
                "4",
                "--size",
                "160x120",
                "--seed",
                "6",
                "--hz",
                "2",
                "--semantics",
                "exact",
                "--flow",
                "--imu",
                "--occupancy",
                "--image-format",
                format
            );
            Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        }
    }

    /// <summary>The session in a format, which is also the end of its images' names.</summary>
    public string SessionOf(string format) => _folder.PathOf($"{format}/session");

    public byte[] Image(string format, int frame) => File.ReadAllBytes(Path.Combine(SessionOf(format), "frames", $"{frame:D8}.{format}"));

    public void Dispose() => _folder.Dispose();
}
