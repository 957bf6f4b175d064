using Harvester.Datasets.Files;
using Harvester.Datasets.Repair;
using Harvester.Datasets.Sharding;
using Harvester.Datasets.Validation;
using Harvester.Geometry.PixelMaps;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Semantics;
using Harvester.TestSupport;

namespace Harvester.Runs.Tests.Relabelling;

/// <summary>The commands that check, copy and rewrite sessions know class maps.</summary>
public sealed class SemanticSessionTests : IDisposable
{
    private const string First = "classes/00000000.png";
    private readonly string _root = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public void Dispose() => Directory.Delete(_root, recursive: true);

    [Theory]
    [InlineData(SemanticsMethod.Rays)]
    [InlineData(SemanticsMethod.Exact)]
    public void Session_is_valid_and_says_where_its_classes_come_from(SemanticsMethod method)
    {
        using var session = new SemanticSession(method);

        Assert.Empty(SessionValidator.Validate(session.Open()).Problems);
        foreach (FrameLabel label in session.Open().ReadLabels())
        {
            ClassMapLabel map = Assert.IsType<ClassMapLabel>(label.ClassMap);
            Assert.Equal(method, map.Method);
            Assert.Equal(label.Rays!.Of("classes"), map.RaysCast);
            Assert.Equal(method == SemanticsMethod.Rays, map.RaysCast > 0);
            InstanceMap classes = PngDecoder.ReadLabelMap(session.PathOf(map.File));
            InstanceMap mask = PngDecoder.ReadInstanceMap(session.PathOf(label.Mask!));
            Assert.Contains((ushort)SemanticClass.Road, classes.Ids);
            Assert.Contains((ushort)SemanticClass.Sky, classes.Ids);
            if (method == SemanticsMethod.Rays)
            {
                Dictionary<int, ObjectLabel> objects = label.Objects.ToDictionary(item => item.Id);
                Assert.All(
                    Enumerable.Range(0, mask.Ids.Length).Where(i => mask.Ids[i] != 0),
                    i => Assert.Equal((ushort)SemanticClasses.Of(objects[mask.Ids[i]].Class), classes.Ids[i])
                );
            }
        }
    }

    [Fact]
    public void Validate_finds_damaged_class_maps()
    {
        using var session = new SemanticSession(SemanticsMethod.Exact);
        InstanceMap map = PngDecoder.ReadLabelMap(session.PathOf(First));
        map.Ids[7] = 22;
        File.Delete(session.PathOf("manifest.jsonl"));
        Write(session.PathOf(First), map);
        File.Delete(session.PathOf("classes/00000001.png"));

        string[] problems = [.. SessionValidator.Validate(session.Open()).Problems.Select(problem => problem.ToString())];

        Assert.Contains(
            problems,
            text =>
                text.Contains(
                    $"line 1: class map '{First}' has values that are no classes: 22. Classes are 0 to 21.",
                    StringComparison.Ordinal
                )
        );
        Assert.Contains(problems, text => text.Contains("line 2: class map 'classes/00000001.png' is missing.", StringComparison.Ordinal));
    }

    [Fact]
    public void Validate_notices_that_a_class_map_was_changed()
    {
        using var session = new SemanticSession(SemanticsMethod.Exact);
        InstanceMap map = PngDecoder.ReadLabelMap(session.PathOf(First));
        map.Ids[7] = map.Ids[7] == 1 ? (ushort)2 : (ushort)1;
        Write(session.PathOf(First), map);

        Assert.Contains(
            SessionValidator.Validate(session.Open()).Problems,
            problem => problem.ToString().Contains($"class map '{First}' ", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Relabel_and_repair_keep_class_maps()
    {
        using var session = new SemanticSession(SemanticsMethod.Rays);
        string relabelled = Path.Combine(_root, "relabelled");
        new SessionRelabeller(session.Open(), new RelabelOptions()).Run(relabelled, _ => { });
        string repaired = Path.Combine(_root, "repaired");
        new SessionRepairer(session.Folder, _ => { }).Run(repaired, ImageTransfer.Copy, SyncMode.Never);

        foreach (string made in (string[])[relabelled, repaired])
        {
            Assert.Empty(SessionValidator.Validate(new SessionReader(made)).Problems);
            Assert.Equal(File.ReadAllBytes(session.PathOf(First)), File.ReadAllBytes(Path.Combine(made, First)));
        }
    }

    [Fact]
    public void Merged_shards_are_the_whole_session()
    {
        using var whole = new SemanticSession(SemanticsMethod.Rays);
        using var one = new SemanticSession(SemanticsMethod.Rays, new Shard(1, 2));
        using var two = new SemanticSession(SemanticsMethod.Rays, new Shard(2, 2));
        string merged = Path.Combine(_root, "merged");
        SessionMerger.Merge([one.Folder, two.Folder], merged, new MergeOptions(ImageTransfer.Copy));

        foreach (string name in (string[])["labels.jsonl", First, "classes/00000001.png"])
        {
            Assert.Equal(File.ReadAllBytes(whole.PathOf(name)), File.ReadAllBytes(Path.Combine(merged, name)));
        }

        Assert.Empty(SessionValidator.Validate(new SessionReader(merged)).Problems);
    }

    private static void Write(string path, InstanceMap map)
    {
        using FileStream file = File.Create(path);
        new PngEncoder().WriteGrey8(map, file);
    }
}
