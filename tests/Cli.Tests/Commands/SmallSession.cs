namespace Harvester.Cli.Tests.Commands;

/// <summary>Two small frames with masks, class maps and lanes.</summary>
public sealed class SmallSession : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public SmallSession() =>
        SharedHarvest.CopyTo(
            Folder,
            "--frames",
            "2",
            "--seed",
            "6",
            "--size",
            "80x60",
            "--semantics",
            "exact",
            "--flow",
            "--imu",
            "--occupancy",
            "--no-report"
        );

    public string Folder => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();
}
