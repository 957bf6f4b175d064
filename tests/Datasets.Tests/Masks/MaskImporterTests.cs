using Harvester.Datasets.Masks;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Masks;

public sealed class MaskImporterTests : MapsOfAnotherTool
{
    [Fact]
    public void Import_gives_visible_boxes_and_occlusion_of_the_maps()
    {
        Session.Lines[1]["somethingNew"] = "keeps ä";
        SessionReader session = Session.Open();

        MaskImport done = MaskImporter.Import(session, Maps, MaskNumbers.Ids);

        Assert.Equal(new MaskImport(3, 6, 6), done);
        Assert.Empty(SessionValidator.Validate(session).Problems);
        Assert.Equal([0, 1, 2], session.ReadLabels().Select(label => label.Frame));
        Assert.All(session.ReadLabels(), AssertHalfHidden);
        Assert.All(session.ReadLabels(), label => Assert.Equal(Scene(Car, Pedestrian).Ids, MaskOf(label).Ids));
        Assert.Contains("\"somethingNew\":\"keeps ä\"", File.ReadAllText(Session.PathOf("labels.jsonl")), StringComparison.Ordinal);
        Assert.Equal(
            ["frames", "labels.jsonl", "manifest.jsonl", "masks", "session.json"],
            Directory.GetFileSystemEntries(Session.Folder).Select(Path.GetFileName).Order()
        );
    }

    [Fact]
    public void Import_by_overlap_finds_objects_and_omits_other_things()
    {
        InstanceMap map = Scene(900, 17);
        Fill(map, 900 + 1, 0, 0, 80, 20);
        // Another thing reaches into the car's cuboid, but has most of its pixels outside.
        Fill(map, 44, 30, 31, 39, 34);
        WriteMap("1.png", map);

        SessionReader session = Session.Open();
        MaskImporter.Import(session, Maps, MaskNumbers.Overlap);

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

        SessionReader session = Session.Open();
        Assert.Equal(5, MaskImporter.Import(session, Maps, MaskNumbers.Ids).Seen);

        ObjectLabel car = session.ReadLabels().Last().Objects[0];
        Assert.Null(car.Box2DVisible);
        Assert.Equal(1, car.OccludedFraction);
        Assert.Equal(0, car.VisibleFraction);
    }

    [Fact]
    public void Import_object_seen_through_a_gap_hides_nothing()
    {
        // The car shows through the pedestrian's column 41.
        InstanceMap map = Scene(Car, Pedestrian);
        Fill(map, Car, 41, 27, 42, 33);
        WriteMap("0.png", map);

        SessionReader session = Session.Open();
        MaskImporter.Import(session, Maps, MaskNumbers.Ids);

        FrameLabel label = session.ReadLabels().First();
        Assert.Equal(0, label.Objects[1].OccludedFraction);
        // Two of six columns are covered now.
        Assert.Equal(0.3333, label.Objects[0].OccludedFraction);
    }

    /// <summary>The pixels of a sign are its own, whatever of it they show; its face is seen where they are.</summary>
    [Theory]
    [InlineData("missing", "no mask for frame 2")]
    [InlineData("size", "is 40 x 60, but the image of frame 2 is 80 x 60")]
    [InlineData("number", "the value 3, which is not the id of an object")]
    [InlineData("truncated", "cut off")]
    [InlineData("damaged", "damaged")]
    [InlineData("colour", "16-bit grey")]
    [InlineData("twice", "both masks of frame 2")]
    public void Import_of_bad_maps_names_them_and_changes_nothing(string fault, string message)
    {
        string map = Path.Combine(Maps, "2.png");
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
                File.Copy(map, Path.Combine(Maps, "00000002.png"));
                break;
        }

        SessionReader session = Session.Open();
        Dictionary<string, byte[]> before = Contents();

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() => MaskImporter.Import(session, Maps, MaskNumbers.Ids));

        Assert.Contains(message, e.Message, StringComparison.Ordinal);
        Assert.Equal(before, Contents());
    }

    [Fact]
    public void Import_reports_a_missing_folder() =>
        Assert.Throws<DirectoryNotFoundException>(() => MaskImporter.Import(Session.Open(), Path.Combine(Maps, "none"), MaskNumbers.Ids));

    [Fact]
    public void Import_cancelled_changes_nothing()
    {
        SessionReader session = Session.Open();
        Dictionary<string, byte[]> before = Contents();

        Assert.Throws<OperationCanceledException>(() =>
            MaskImporter.Import(session, Maps, MaskNumbers.Ids, cancellation: new CancellationToken(true))
        );

        Assert.Equal(before, Contents());
    }

    private static void AssertHalfHidden(FrameLabel label)
    {
        ObjectLabel car = label.Objects[0];
        Assert.Equal(new Box2D(37, 27, 40, 33), car.Box2DVisible);
        Assert.Equal((0.5, 0.5, OcclusionMethod.Imported), (car.OccludedFraction, car.VisibleFraction, car.OcclusionMethod));
        ObjectLabel pedestrian = label.Objects[1];
        Assert.Equal(new Box2D(40, 24, 46, 36), pedestrian.Box2DVisible);
        Assert.Equal(
            (0, 1, OcclusionMethod.Imported),
            (pedestrian.OccludedFraction, pedestrian.VisibleFraction, pedestrian.OcclusionMethod)
        );
    }

    private Dictionary<string, byte[]> Contents() =>
        Directory.GetFiles(Session.Folder, "*", SearchOption.AllDirectories).ToDictionary(file => file, File.ReadAllBytes);
}
