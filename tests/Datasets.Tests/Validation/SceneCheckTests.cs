using Harvester.Datasets.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenarios;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Scenes that are gone or damaged.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class SceneCheckTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public SceneCheckTests(SimulatedSession session)
    {
        foreach (string file in Directory.EnumerateFiles(session.Folder, "*", SearchOption.AllDirectories))
        {
            string target = Path.Combine(_folder, Path.GetRelativePath(session.Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target);
        }
    }

    private string Scene => Path.Combine(_folder, FramePaths.Scene(2));

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Validate_of_a_harvest_with_masks_and_scenes_finds_nothing() => Assert.Empty(Problems());

    [Fact]
    public void Validate_finds_a_truncated_scene()
    {
        File.WriteAllBytes(Scene, File.ReadAllBytes(Scene)[..400]);

        Assert.StartsWith(
            "labels.jsonl, line 3: scene 'scenes/00000002.json' cannot be used: invalid JSON",
            Assert.Single(Problems()),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Validate_finds_a_missing_scene()
    {
        File.Delete(Scene);

        Assert.Equal("labels.jsonl, line 3: scene 'scenes/00000002.json' is missing.", Assert.Single(Problems()));
    }

    [Fact]
    public void Validate_finds_that_all_scenes_are_missing()
    {
        Directory.Delete(Path.GetDirectoryName(Scene)!, recursive: true);

        Assert.Equal(SimulatedSession.Frames, Problems().Length);
    }

    [Theory]
    [InlineData(FramePaths.Roads, "node,1,0,0\n", "line 1")]
    [InlineData(FramePaths.Roads, "\u0089PNG", "line 1")]
    [InlineData(FramePaths.Faces, "# faces\nprop_sign_road_01a,0\n", "line 2, row")]
    [InlineData(ScenarioRecord.FileName, "{\n\"seed\": 1,}\n", "invalid JSON at line 2")]
    public void Validate_finds_unreadable_roads_faces_and_scenarios(string name, string content, string place)
    {
        File.WriteAllText(Path.Combine(_folder, name), content);

        Assert.StartsWith($"{name}: {place}", Assert.Single(Problems()), StringComparison.Ordinal);
    }

    [Fact]
    public void Validate_reads_roads_and_faces_only_if_present()
    {
        File.Delete(Path.Combine(_folder, FramePaths.Roads));
        File.Delete(Path.Combine(_folder, FramePaths.Faces));

        Assert.Empty(Problems());
    }

    private string[] Problems() =>
        [.. SessionValidator.Validate(new SessionReader(_folder)).Problems.Select(problem => problem.ToString())];
}
