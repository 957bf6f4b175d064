using Harvester.Cli.Terminals;
using Harvester.Geometry.Motion;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Maps of flow from the command line to the commands that read a session.</summary>
public sealed class HarvestFlowTests : IDisposable
{
    private static readonly string[] Folders =
    [
        "flow-backward",
        "flow-forward",
        "flow-motion",
        "flow-backward-flags",
        "flow-forward-flags",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Frames_after_the_first_of_a_place_have_flow()
    {
        string session = Harvest("session", "--frames", "4", "--places", "2");
        CliRun.Of("validate", "--schema", session).AssertDone();

        Assert.Equal([null, 0, null, 2], new SessionReader(session).ReadLabels().Select(label => FlowOf(label)?.From));
        Assert.All(Folders, folder => Assert.Equal(2, Directory.GetFiles(Path.Combine(session, folder)).Length));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Shards_merge_to_the_bytes_of_a_whole_session()
    {
        string whole = Harvest("whole", "--frames", "6", "--places", "2");
        string[] parts =
        [
            .. Enumerable.Range(1, 3).Select(part => Harvest($"part-{part}", "--frames", "6", "--places", "2", "--shard", $"{part}/3")),
        ];
        CliRun.Of(["merge", .. parts, "--out", _folder.PathOf("merged"), "--no-report"]).AssertDone();

        AssertSame(whole, _folder.PathOf("merged"));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Resumed_session_has_the_bytes_of_a_whole_one()
    {
        string whole = Harvest("whole", "--frames", "6", "--places", "2");
        string torn = Harvest("torn", "--frames", "6", "--places", "2");
        string labels = Path.Combine(torn, "labels.jsonl");

        // The session ends after frame 4, so that the next one, 5, needs the flow from a frame that the session holds.
        File.WriteAllText(labels, string.Concat(File.ReadAllLines(labels).Take(5).Select(line => line + "\n")));
        foreach (string folder in Folders)
        {
            File.Delete(Path.Combine(torn, folder, "00000005.png"));
        }

        File.WriteAllText(
            Path.Combine(torn, ".harvester-unfinished"),
            "harvester harvest --size 80x60 --flow --seed 3 --no-report --frames 6 --places 2"
        );
        Harvest("torn", "--frames", "6", "--places", "2", "--resume");

        AssertSame(whole, torn);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Views_of_a_rig_have_the_flow_of_their_own_camera()
    {
        string rig = _folder.File("rig.json", HarvestedRig.Rig);
        string[] options = ["--frames", "3", "--hz", "2", "--places", "1", "--rig", rig, "--flow", "--seed", "3", "--no-report"];
        string[] sessions = [_folder.PathOf("rig"), _folder.PathOf("rig-1"), _folder.PathOf("rig-2")];
        CliRun.Of(["harvest", "--out", sessions[0], .. options]).AssertDone();
        CliRun.Of(["harvest", "--out", sessions[1], "--shard", "1/2", .. options]).AssertDone();
        CliRun.Of(["harvest", "--out", sessions[2], "--shard", "2/2", .. options]).AssertDone();
        CliRun.Of("validate", "--schema", sessions[0]).AssertDone();
        CliRun.Of("merge", sessions[1], sessions[2], "--out", _folder.PathOf("merged"), "--no-report").AssertDone();

        Assert.Equal([null, null, 0, 1, 2, 3], new SessionReader(sessions[0]).ReadLabels().Select(label => FlowOf(label)?.From));
        Assert.True(File.Exists(Path.Combine(sessions[0], "flow-backward", "right", "00000003.png")));
        AssertSame(sessions[0], _folder.PathOf("merged"));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Maps_that_disagree_are_a_problem()
    {
        string session = Harvest("damaged", "--frames", "2", "--places", "1");
        FlowFiles maps = FlowOf(new SessionReader(session).ReadLabels().Last())!.Maps;
        File.Copy(Path.Combine(session, maps.Motion), Path.Combine(session, maps.Forward), overwrite: true);
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains(
            $"map of flow '{maps.Forward}' and '{maps.ForwardFlags}' disagree on column",
            validated.Out,
            StringComparison.Ordinal
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Flags_that_exclude_each_other_are_a_problem()
    {
        string session = Harvest("flags", "--frames", "2", "--places", "1", "--masks", "--semantics", "rays");
        FrameLabel label = new SessionReader(session).ReadLabels().Last();
        FlowFiles maps = FlowOf(label)!.Maps;
        string classes = label.Channels.Get<ClassMapLabel>()!.File;
        File.Copy(Path.Combine(session, classes), Path.Combine(session, maps.BackwardFlags), overwrite: true);
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains($"map of flow '{maps.BackwardFlags}' has the number", validated.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Maps_are_kept_unless_the_lens_changes()
    {
        string session = Harvest("session", "--frames", "2", "--places", "1");
        string lens = _folder.File("lens.ini", "[Lens]\nFocalScale = 1.02\nCentreOffsetX = 0.001\nCentreOffsetY = 0\nK1 = -0.03\nK2 = 0\n");
        CliRun.Of("relabel", session, "--out", _folder.PathOf("same"), "--range", "30", "--no-report").AssertDone();
        CliRun.Of("relabel", session, "--out", _folder.PathOf("bent"), "--calibration", lens, "--no-report").AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("same")).AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("bent")).AssertDone();

        Assert.NotNull(FlowOf(new SessionReader(_folder.PathOf("same")).ReadLabels().Last()));
        Assert.Null(FlowOf(new SessionReader(_folder.PathOf("bent")).ReadLabels().Last()));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Numbers_of_a_map_are_those_of_the_docs()
    {
        string session = Harvest("session", "--frames", "2", "--places", "1");
        FlowFiles maps = FlowOf(new SessionReader(session).ReadLabels().Last())!.Maps;
        ushort[] flow = PngDecoder.ReadDeepColour(Path.Combine(session, maps.Backward));
        ushort[] flags = PngDecoder.ReadLabelMap(Path.Combine(session, maps.BackwardFlags)).Ids;

        Assert.All(
            Enumerable.Range(0, flags.Length),
            at => Assert.Equal(((FlowFlags)flags[at]).HasFlag(FlowFlags.Valid) ? 1 : 0, flow[(3 * at) + 2])
        );
        Assert.Contains(flags, number => (FlowFlags)number == FlowFlags.Valid);
    }

    /// <summary>The labels of two sessions and all files that they name are the same.</summary>
    private static void AssertSame(string expected, string found)
    {
        Assert.Equal(File.ReadAllText(Path.Combine(expected, "labels.jsonl")), File.ReadAllText(Path.Combine(found, "labels.jsonl")));
        foreach (string file in new SessionReader(expected).ReadLabels().SelectMany(label => label.Files))
        {
            Assert.True(File.ReadAllBytes(Path.Combine(expected, file)).SequenceEqual(File.ReadAllBytes(Path.Combine(found, file))), file);
        }
    }

    private static FlowLabel? FlowOf(FrameLabel label) => label.Channels.Get<FlowLabel>();

    private string Harvest(string name, params string[] options)
    {
        string session = _folder.PathOf(name);
        CliRun.Of(["harvest", "--out", session, "--size", "80x60", "--flow", "--seed", "3", "--no-report", .. options]).AssertDone();
        return session;
    }
}
