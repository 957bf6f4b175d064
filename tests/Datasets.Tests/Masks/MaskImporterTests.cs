using System.Text.Json.Nodes;
using Harvester.Capture.Imaging;
using Harvester.Capture.Labels;
using Harvester.Datasets.Images;
using Harvester.Datasets.Masks;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Datasets.Tests.Masks;

public sealed class MaskImporterTests : IDisposable
{
    private const ushort Car = 1;
    private const ushort Pedestrian = 2;
    private const ushort Sign = 3;
    private const ushort Face = 4;

    private readonly TestSession _session = new();
    private readonly string _maps = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public MaskImporterTests()
    {
        // The pedestrian steps before the right half of the car: 0 to 1 m right at 5 m is columns 40 to 45, ±1 m is rows 24 to 35.
        foreach (JsonObject line in _session.Lines)
        {
            JsonObject pedestrian = line["objects"]![1]!.AsObject();
            pedestrian["box3d"]!["centre"] = new JsonArray(0.5, 5, 0);
            pedestrian["box3d"]!["halfExtents"] = new JsonArray(0.5, 0, 1);
            pedestrian["box2d"] = new JsonArray(40, 24, 46, 36);
            pedestrian["box2dAmodal"] = new JsonArray(40, 24, 46, 36);
            pedestrian["truncatedFraction"] = 0;
            pedestrian["distanceMetres"] = 5.0249;
        }

        for (int frame = 0; frame < 3; frame++)
        {
            WriteMap($"{frame}.png", Scene(Car, Pedestrian));
        }
    }

    public void Dispose()
    {
        _session.Dispose();
        Directory.Delete(_maps, recursive: true);
    }

    [Fact]
    public void Import_gives_visible_boxes_and_occlusion_of_the_maps()
    {
        _session.Lines[1]["somethingNew"] = "keeps ä";
        SessionReader session = _session.Open();

        MaskImport done = MaskImporter.Import(session, _maps, MaskNumbers.Ids);

        Assert.Equal(new MaskImport(3, 6, 6), done);
        Assert.Empty(SessionValidator.Validate(session).Problems);
        Assert.Equal([0, 1, 2], session.ReadLabels().Select(label => label.Frame));
        Assert.All(session.ReadLabels(), AssertHalfHidden);
        Assert.All(session.ReadLabels(), label => Assert.Equal(Scene(Car, Pedestrian).Ids, MaskOf(label).Ids));
        Assert.Contains("\"somethingNew\":\"keeps ä\"", File.ReadAllText(_session.PathOf("labels.jsonl")), StringComparison.Ordinal);
        Assert.Equal(["frames", "labels.jsonl", "masks", "session.json"], Directory.GetFileSystemEntries(_session.Folder).Select(Path.GetFileName).Order());
    }

    [Fact]
    public void Import_by_overlap_finds_the_objects_and_leaves_out_other_things()
    {
        InstanceMap map = Scene(900, 17);
        Fill(map, 900 + 1, 0, 0, 80, 20);
        // Another thing reaches into the car's cuboid, but has most of its pixels outside.
        Fill(map, 44, 30, 31, 39, 34);
        WriteMap("1.png", map);

        SessionReader session = _session.Open();
        MaskImporter.Import(session, _maps, MaskNumbers.Overlap);

        FrameLabel label = session.ReadLabels().ElementAt(1);
        InstanceMap expected = Scene(Car, Pedestrian);
        Fill(expected, 0, 30, 31, 39, 34);
        Assert.Equal(expected.Ids, MaskOf(label).Ids);
        AssertHalfHidden(session.ReadLabels().First());
    }

    [Fact]
    public void Import_object_without_a_pixel_is_hidden()
    {
        WriteMap("2.png", Scene(0, Pedestrian));

        SessionReader session = _session.Open();
        Assert.Equal(5, MaskImporter.Import(session, _maps, MaskNumbers.Ids).Seen);

        ObjectLabel car = session.ReadLabels().Last().Objects[0];
        Assert.Null(car.Box2DVisible);
        Assert.Equal(1, car.OccludedFraction);
        Assert.Equal(0, car.VisibleFraction);
    }

    [Fact]
    public void Import_farther_object_seen_through_a_gap_hides_nothing()
    {
        // The car shows through the pedestrian's column 41.
        InstanceMap map = Scene(Car, Pedestrian);
        Fill(map, Car, 41, 27, 42, 33);
        WriteMap("0.png", map);

        SessionReader session = _session.Open();
        MaskImporter.Import(session, _maps, MaskNumbers.Ids);

        FrameLabel label = session.ReadLabels().First();
        Assert.Equal(0, label.Objects[1].OccludedFraction);
        // Two of six columns are covered now.
        Assert.Equal(0.3333, label.Objects[0].OccludedFraction);
    }

    /// <summary>The pixels of a sign are its own, whatever of it they show; its face is seen where they are.</summary>
    [Theory]
    [InlineData(Sign, Sign, MaskNumbers.Ids)]
    [InlineData(Face, Sign, MaskNumbers.Ids)]
    [InlineData(900, 900, MaskNumbers.Overlap)]
    public void Import_gives_a_sign_its_pixels_and_shows_its_face(ushort face, ushort post, MaskNumbers numbers)
    {
        _session.AddSign(0);
        WriteMap("0.png", SceneWithSign(face, post));
        SessionReader session = _session.Open();

        MaskImport done = MaskImporter.Import(session, _maps, numbers);

        FrameLabel label = session.ReadLabels().First();
        Assert.Equal(8, done.Seen);
        Assert.Equal(SceneWithSign(Sign, Sign).Ids, MaskOf(label).Ids);
        Assert.Equal(new Box2D(15, 15, 25, 40), label.Objects[2].Box2DVisible);
        ObjectLabel part = label.Objects[3];
        Assert.Equal((null, 0, 1, OcclusionMethod.Imported), (part.Box2DVisible, part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod));
        Assert.Empty(SessionValidator.Validate(session).Problems);
    }

    [Fact]
    public void Import_hides_a_face_by_as_much_as_a_nearer_object_covers()
    {
        // The face is in columns 15 to 25; the pedestrian, 5 m away where the face is 6 m away, stands before columns 20 to 25.
        _session.AddSign(0);
        JsonObject pedestrian = _session.Pedestrian(0);
        pedestrian["box3d"]!["centre"] = new JsonArray(-2.5, 5, 1.5);
        pedestrian["box3d"]!["halfExtents"] = new JsonArray(5.0 / 6, 0, 1);
        pedestrian["box2d"] = new JsonArray(20, 15, 30, 27);
        InstanceMap map = SceneWithSign(Sign, Sign);
        Fill(map, 0, 43, 24, 46, 36);
        Fill(map, Pedestrian, 20, 15, 30, 27);
        WriteMap("0.png", map);
        SessionReader session = _session.Open();

        MaskImporter.Import(session, _maps, MaskNumbers.Ids);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((0.5, 0.5, OcclusionMethod.Imported), (part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod));
    }

    [Fact]
    public void Import_hides_a_face_where_its_sign_is_not_seen()
    {
        // Nothing but the post is seen.
        _session.AddSign(0);
        WriteMap("0.png", SceneWithSign(0, Sign));
        SessionReader session = _session.Open();

        Assert.Equal(7, MaskImporter.Import(session, _maps, MaskNumbers.Ids).Seen);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((1, 0, OcclusionMethod.Imported), (part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod));
    }

    /// <summary>A map does not tell the face from the rest of its sign, which may hide it; rays do.</summary>
    [Fact]
    public void Import_keeps_what_rays_found_hidden_of_a_face_that_nothing_else_covers()
    {
        _session.AddSign(0);
        JsonNode face = _session.Lines[0]["objects"]![3]!;
        face["occludedFraction"] = 0.7;
        face["visibleFraction"] = 0.3;
        WriteMap("0.png", SceneWithSign(Sign, Sign));
        SessionReader session = _session.Open();

        MaskImporter.Import(session, _maps, MaskNumbers.Ids);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((0.7, OcclusionMethod.Rays), (part.OccludedFraction, part.OcclusionMethod));
    }

    [Fact]
    public void Import_shows_a_face_smaller_than_a_pixel()
    {
        // 0.02 m wide at 6 m are 0.1 pixels: columns 19.95 to 20.05, between the centres of 19 and 20, which the post shows too.
        _session.AddSign(0);
        JsonNode face = _session.Lines[0]["objects"]![3]!;
        face["box3d"]!["halfExtents"] = new JsonArray(0.01, 0.005, 1);
        face["box2d"] = new JsonArray(19.95, 15, 20.05, 25);
        face["box2dAmodal"] = new JsonArray(19.95, 15, 20.05, 25);
        WriteMap("0.png", SceneWithSign(Sign, Sign));
        SessionReader session = _session.Open();

        MaskImporter.Import(session, _maps, MaskNumbers.Ids);

        Assert.Equal(0, session.ReadLabels().First().Objects[3].OccludedFraction);
    }

    [Theory]
    [InlineData("missing", "no map of frame 2")]
    [InlineData("size", "is 40 x 60, but the image of frame 2 is 80 x 60")]
    [InlineData("number", "the number 3, which is no object's id")]
    [InlineData("truncated", "cut off")]
    [InlineData("damaged", "damaged")]
    [InlineData("colour", "16-bit grey")]
    [InlineData("twice", "both of frame 2")]
    public void Import_of_bad_maps_says_which_and_changes_nothing(string fault, string message)
    {
        string map = Path.Combine(_maps, "2.png");
        byte[] good = File.ReadAllBytes(map);
        switch (fault)
        {
            case "missing":
                File.Delete(map);
                break;
            case "size":
                WriteMap("2.png", new InstanceMap(new ImageSize(40, 60)));
                break;
            case "number":
                WriteMap("2.png", Scene(Car, 3));
                break;
            case "truncated":
                File.WriteAllBytes(map, good[..(good.Length / 2)]);
                break;
            case "damaged":
                // The data that the header promises, less most of it: IHDR ends at 33, IDAT's data begin at 41, the file's end is kept.
                good.AsSpan(45, good.Length - 45 - 16).Clear();
                File.WriteAllBytes(map, good);
                break;
            case "colour":
                File.WriteAllBytes(map, TestImages.Png(TestSession.Width, TestSession.Height));
                break;
            default:
                File.Copy(map, Path.Combine(_maps, "00000002.png"));
                break;
        }

        SessionReader session = _session.Open();
        Dictionary<string, byte[]> before = Contents();

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() => MaskImporter.Import(session, _maps, MaskNumbers.Ids));

        Assert.Contains(message, e.Message, StringComparison.Ordinal);
        Assert.Equal(before, Contents());
    }

    [Fact]
    public void Import_of_no_folder_says_so() => Assert.Throws<DirectoryNotFoundException>(
        () => MaskImporter.Import(_session.Open(), Path.Combine(_maps, "none"), MaskNumbers.Ids));

    [Fact]
    public void Import_cancelled_changes_nothing()
    {
        SessionReader session = _session.Open();
        Dictionary<string, byte[]> before = Contents();

        Assert.Throws<OperationCanceledException>(() => MaskImporter.Import(session, _maps, MaskNumbers.Ids, new CancellationToken(true)));

        Assert.Equal(before, Contents());
    }

    private static void AssertHalfHidden(FrameLabel label)
    {
        ObjectLabel car = label.Objects[0];
        Assert.Equal(new Box2D(37, 27, 40, 33), car.Box2DVisible);
        Assert.Equal((0.5, 0.5, OcclusionMethod.Imported), (car.OccludedFraction, car.VisibleFraction, car.OcclusionMethod));
        ObjectLabel pedestrian = label.Objects[1];
        Assert.Equal(new Box2D(40, 24, 46, 36), pedestrian.Box2DVisible);
        Assert.Equal((0, 1, OcclusionMethod.Imported), (pedestrian.OccludedFraction, pedestrian.VisibleFraction, pedestrian.OcclusionMethod));
    }

    // The car's near face is 6 x 6 pixels around (40, 30).
    private static InstanceMap Scene(ushort car, ushort pedestrian)
    {
        var map = new InstanceMap(new ImageSize(TestSession.Width, TestSession.Height));
        Fill(map, car, 37, 27, 43, 33);
        Fill(map, pedestrian, 40, 24, 46, 36);
        return map;
    }

    // As TestSession.AddSign describes it: the face on its post, left of the others.
    private static InstanceMap SceneWithSign(ushort face, ushort post)
    {
        InstanceMap map = Scene(Car, Pedestrian);
        Fill(map, face, 15, 15, 25, 25);
        Fill(map, post, 19, 25, 21, 40);
        return map;
    }

    private static void Fill(InstanceMap map, ushort number, int left, int top, int right, int bottom)
    {
        for (int row = top; row < bottom; row++)
        {
            for (int column = left; column < right; column++)
            {
                map[column, row] = number;
            }
        }
    }

    private InstanceMap MaskOf(FrameLabel label) => PngDecoder.ReadInstanceMap(_session.PathOf(label.Mask!));

    private void WriteMap(string name, InstanceMap map)
    {
        using FileStream file = File.Create(Path.Combine(_maps, name));
        new PngEncoder().Write(map, file);
    }

    private Dictionary<string, byte[]> Contents() =>
        Directory.GetFiles(_session.Folder, "*", SearchOption.AllDirectories).ToDictionary(file => file, File.ReadAllBytes);
}
