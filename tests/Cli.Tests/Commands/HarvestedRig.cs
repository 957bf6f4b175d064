namespace Harvester.Cli.Tests.Commands;

/// <summary>A small harvest of two cameras of different sizes a LiDAR and a radar, as a whole and in two shards.</summary>
public sealed class HarvestedRig : IDisposable
{
    public const string Rig = """
        {"name":"pair","cameras":[
        {"name":"left","position":[-0.3,2,0.4],"verticalFovDegrees":50,"width":80,"height":60},
        {"name":"right","position":[0.3,2,0.4],"yawDegrees":-10,"verticalFovDegrees":60,"width":64,"height":64}],
        "lidars":[{"name":"top","position":[0,0,1.6],"beamsDegrees":[0,-4,-8],"columns":40}],
        "radars":[{"name":"ahead","position":[0,2,0.4],"rangeNoiseMetres":0.1,"velocityNoise":0.1,"ghostFraction":0.2,"clutter":3}]}
        """;

    /// <summary>The options of the harvest beside --out and --rig; one that resumes it must have the same.</summary>
    public static IReadOnlyList<string> Options { get; } =
        "--frames 4 --hz 2 --seed 3 --places 2 --masks --depth --occupancy --no-report".Split(' ');

    private readonly TemporaryFolder _folder = new();

    public HarvestedRig()
    {
        RigFile = _folder.File("rig.json", Rig);
        Harvest("session");
        Harvest("part-1", "--shard", "1/2");
        Harvest("part-2", "--shard", "2/2");
    }

    public string RigFile { get; }

    public string Session => PathOf("session");

    public void Dispose() => _folder.Dispose();

    public string PathOf(string name) => _folder.PathOf(name);

    private void Harvest(string name, params string[] more) =>
        CliRun.Of(["harvest", "--out", PathOf(name), "--rig", RigFile, .. Options, .. more]).AssertDone();
}
