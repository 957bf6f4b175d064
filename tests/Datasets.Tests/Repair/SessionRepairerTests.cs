using Harvester.Datasets.Files;
using Harvester.Datasets.Repair;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Tests.Repair;

public sealed class SessionRepairerTests(DamagedSession session) : IClassFixture<DamagedSession>, IDisposable
{
    private readonly List<string> _reported = [];

    public void Dispose() => session.Restore();

    [Fact]
    public void Undamaged_session_is_recovered_whole()
    {
        Assert.Equal(new SessionRepair(3, 0, true), Repair());
        Assert.Empty(_reported);
        Assert.Equal(File.ReadAllLines(session.PathOf("labels.jsonl")), File.ReadAllLines(Path.Combine(session.Repaired, "labels.jsonl")));
        Assert.True(File.Exists(Path.Combine(session.Repaired, FramePaths.Roads)));
        Assert.True(File.Exists(Path.Combine(session.Repaired, FramePaths.Faces)));
    }

    [Theory]
    [InlineData("frames/00000001.png", "image")]
    [InlineData("masks/00000001.png", "mask")]
    [InlineData("scenes/00000001.json", "scene")]
    public void Frame_with_a_damaged_file_is_lost(string name, string named)
    {
        session.Flip(name, session.Bits(name) / 2);

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.StartsWith($"labels.jsonl, line 2: {named}", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("frames/00000001.png")]
    [InlineData("masks/00000001.png")]
    [InlineData("scenes/00000001.json")]
    public void Frame_with_a_missing_file_is_lost(string name)
    {
        File.Delete(session.PathOf(name));

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.Contains($"'{name}' is missing", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("frames/00000001.png")]
    [InlineData("masks/00000001.png")]
    [InlineData("scenes/00000001.json")]
    public void Frame_with_a_file_outside_the_session_is_lost(string name)
    {
        File.Move(session.PathOf(name), Path.Combine(session.Folder, "..", "outside"), overwrite: true);
        File.CreateSymbolicLink(session.PathOf(name), Path.Combine("..", "..", "outside"));

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.Contains("points outside", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Fact]
    public void Manifest_of_empty_lines_is_not_read_to_its_end()
    {
        File.WriteAllText(session.PathOf(Manifest.FileName), new string('\n', 2 * ProblemList.MaxProblems));

        Assert.Equal(new SessionRepair(3, 0, false), Repair());
        Assert.InRange(
            _reported.Count(line => line.StartsWith(Manifest.FileName, StringComparison.Ordinal)),
            1,
            ProblemList.MaxProblems + 1
        );
    }

    [Fact]
    public void Damaged_frame_number_costs_only_its_own_frame()
    {
        // {"frame":0 becomes {"frame":8: the bit of value 8 of the tenth byte.
        session.Flip("labels.jsonl", (9 * 8) + 3);

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.StartsWith("labels.jsonl, line 1: ", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Fact]
    public void Damaged_label_line_is_lost()
    {
        string[] lines = File.ReadAllLines(session.PathOf("labels.jsonl"));
        File.WriteAllText(session.PathOf("labels.jsonl"), $"{lines[0]}\n{lines[1][..^40]}\n{lines[2]}\n");

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.StartsWith("labels.jsonl, line 2: ", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Fact]
    public void Unfinished_last_line_is_left_out()
    {
        string[] lines = File.ReadAllLines(session.PathOf("labels.jsonl"));
        File.WriteAllText(session.PathOf("labels.jsonl"), $"{lines[0]}\n{lines[1]}\n{lines[2][..^40]}");

        Assert.Equal(new SessionRepair(2, 1, false), Repair());
        Assert.Contains("unfinished last line", _reported[0], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void Frames_without_a_label_line_are_lost(int kept)
    {
        string[] lines = File.ReadAllLines(session.PathOf("labels.jsonl"));
        File.WriteAllText(session.PathOf("labels.jsonl"), string.Concat(lines[..kept].Select(line => line + "\n")));

        Assert.Equal(new SessionRepair(kept, 3 - kept, false), Repair());
        Assert.Equal($"labels.jsonl: it has {kept} of the 3 frames that session.json counts.", Assert.Single(_reported));
    }

    [Fact]
    public void Missing_labels_lose_every_frame()
    {
        File.Delete(session.PathOf("labels.jsonl"));

        Assert.Equal(new SessionRepair(0, 3, false), Repair());
    }

    [Fact]
    public void Damaged_manifest_line_costs_no_frame()
    {
        session.Flip("manifest.jsonl", 100);

        Assert.Equal(new SessionRepair(3, 0, false), Repair());
        Assert.StartsWith("manifest.jsonl, line 1: ", Assert.Single(_reported), StringComparison.Ordinal);
    }

    [Fact]
    public void Missing_manifest_costs_no_frame()
    {
        File.Delete(session.PathOf("manifest.jsonl"));

        Assert.Equal(new SessionRepair(3, 0, true), Repair());
    }

    [Theory]
    [InlineData("scenes/roads.csv")]
    [InlineData("scenes/spaces.csv")]
    public void Damaged_common_file_is_left_out(string name)
    {
        session.Flip(name, session.Bits(name) / 2);

        Assert.Equal(3, Repair().Frames);
        Assert.StartsWith(name, _reported[0], StringComparison.Ordinal);
        Assert.False(File.Exists(Path.Combine(session.Repaired, name)));
    }

    [Fact]
    public void Flipped_bit_in_session_json_is_corrected()
    {
        session.Flip("session.json", session.Bits("session.json") / 2);

        Assert.Equal(new SessionRepair(3, 0, false), Repair());
        Assert.Equal("session.json: one flipped bit was corrected.", Assert.Single(_reported));
    }

    [Theory]
    [InlineData(null)]
    [InlineData("{\"formatVersion\":")]
    public void Lost_session_json_is_made_anew(string? text)
    {
        File.Delete(session.PathOf("session.json"));
        if (text is not null)
        {
            File.WriteAllText(session.PathOf("session.json"), text);
        }

        Assert.Equal(3, Repair().Frames);
        Assert.Contains("game, options and lens are lost", _reported[0], StringComparison.Ordinal);
        Assert.Equal("unknown", new SessionReader(session.Repaired).ReadInfo().Game);
    }

    [Fact]
    public void Session_without_anything_whole_is_refused()
    {
        File.Delete(session.PathOf("session.json"));
        File.WriteAllText(session.PathOf("labels.jsonl"), "{\n");

        Assert.Throws<DatasetFormatException>(() => Run());
        Assert.False(File.Exists(Path.Combine(session.Repaired, "session.json")));
    }

    private SessionRepair Run() =>
        new SessionRepairer(session.Folder, problem => _reported.Add(problem.ToString())).Run(
            session.Repaired,
            ImageTransfer.Copy,
            SyncMode.Never
        );

    /// <summary>Repairs, and checks that the result is valid and the damaged session unchanged.</summary>
    private SessionRepair Repair()
    {
        Dictionary<string, byte[]> before = Contents();
        SessionRepair repair = Run();
        Assert.Equal(before, Contents());
        SessionValidation made = SessionValidator.Validate(new SessionReader(session.Repaired));
        Assert.Empty(made.Problems);
        Assert.Equal(repair.Frames, made.Frames);
        return repair;
    }

    private Dictionary<string, byte[]> Contents() =>
        Directory.EnumerateFiles(session.Folder, "*", SearchOption.AllDirectories).ToDictionary(file => file, File.ReadAllBytes);
}
