using Harvester.Datasets.Sharding;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Visibility;
using Harvester.Runs.Relabelling;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;
using static Harvester.Runs.Tests.Relabelling.LabelContent;

namespace Harvester.Runs.Tests.Relabelling;

/// <summary>A relabelling is compared with a harvest of the same drive with these options.</summary>
public sealed class SessionRelabellerTests(RecordedDrive drive) : IClassFixture<RecordedDrive>
{
    private static readonly Lens Bent = new(1.03, 0.004, -0.002, -0.04, 0.01);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Relabel_with_the_own_options_gives_the_same_bytes(bool masks)
    {
        SessionReader recorded = masks ? drive.MaskedSession : drive.Session;

        SessionReader made = Relabel(recorded, new RelabelOptions { Roads = drive.Roads, Classes = Enum.GetValues<ObjectClass>() });

        string[] files =
        [
            SessionReader.LabelsFile,
            .. recorded.ReadLabels().Select(label => label.Image),
            .. recorded.ReadLabels().Select(label => label.Mask).OfType<string>(),
        ];
        Assert.Equal(1 + (RecordedDrive.Frames * (masks ? 2 : 1)), files.Length);
        Assert.All(files, file => Assert.Equal(File.ReadAllBytes(recorded.PathOf(file)), File.ReadAllBytes(made.PathOf(file))));
        Assert.True(recorded.ReadLabels().Sum(label => label.Objects.Count) > 10 * RecordedDrive.Frames);
    }

    [Fact]
    public void Relabel_with_range_classes_and_sizes_equals_a_harvest()
    {
        ObjectClass[] classes = [ObjectClass.Car, ObjectClass.Truck, ObjectClass.Sign];
        SessionReader harvested = drive.Harvest(
            "narrow",
            RecordedDrive.Options with
            {
                RangeMetres = 35,
                Classes = classes,
                MinBoxAreaPixels = 40,
                MinBoxSidePixels = 5,
                MaxOccludedFraction = 0.5,
            }
        );

        SessionReader made = Relabel(
            drive.Session,
            new RelabelOptions
            {
                RangeMetres = 35,
                Classes = classes,
                MinBoxAreaPixels = 40,
                MinBoxSidePixels = 5,
                MaxOccludedFraction = 0.5,
                Roads = drive.Roads,
            }
        );

        // The narrow harvest looks at what lies between the two ranges with few rays, which are the first of those that the wide one casts.
        Assert.Equal(ComparedLabels.Of(harvested, regions: IsBeyondBoth), ComparedLabels.Of(made, regions: IsBeyondBoth));
        Assert.All(harvested.ReadLabels().Zip(made.ReadLabels()), frame => Assert.Superset(Seen(frame.First), Seen(frame.Second)));
        Assert.Contains(made.ReadLabels(), label => label.IgnoreRegions.Any(region => !IsBeyondBoth(region)));
        Assert.NotEqual(ComparedLabels.Of(drive.Session), ComparedLabels.Of(made));
        Assert.Equal(
            ["car", "truck", "sign"],
            SessionHeader(made).GetProperty("classes").EnumerateArray().Select(name => name.GetString())
        );
        Assert.Equal(35, SessionHeader(made).GetProperty("options").GetProperty("rangeMetres").GetDouble());
    }

    [Fact]
    public void Relabel_with_hidden_objects_equals_a_harvest_with_them()
    {
        SessionReader made = Relabel(drive.Session, new RelabelOptions { MaxOccludedFraction = 1, Roads = drive.Roads });

        // No rays were cast for the joints of people who were not listed.
        var listed = drive.Session.ReadLabels().SelectMany(label => label.Objects).Select(item => item.Box3D.Centre).ToHashSet();
        ObjectLabel Known(ObjectLabel item) => listed.Contains(item.Box3D.Centre) ? item : ComparedLabels.WithoutVisibleJoints(item);
        Assert.Equal(ComparedLabels.Of(drive.FullSession, Known), ComparedLabels.Of(made, Known));
        Assert.True(
            drive.FullSession.ReadLabels().Sum(label => label.Objects.Count) > drive.Session.ReadLabels().Sum(label => label.Objects.Count)
        );
    }

    [Fact]
    public void Relabel_restores_other_classes_with_unknown_occlusion()
    {
        SessionReader cars = drive.Harvest("cars", RecordedDrive.Options with { Classes = [ObjectClass.Car] });

        SessionReader made = Relabel(cars, new RelabelOptions { Classes = Enum.GetValues<ObjectClass>() });

        ObjectLabel[] others = [.. made.ReadLabels().SelectMany(label => label.Objects).Where(item => item.Class != ObjectClass.Car)];
        Assert.NotEmpty(others);
        Assert.All(others, item => Assert.Equal((null, OcclusionMethod.None), (item.OccludedFraction, item.OcclusionMethod)));
        Assert.All(made.ReadLabels().Zip(drive.Session.ReadLabels()), frame => Assert.Superset(Places(frame.Second), Places(frame.First)));
    }

    [Fact]
    public void Relabel_through_a_lens_equals_a_harvest_through_it()
    {
        SessionReader harvested = drive.Harvest("bent", RecordedDrive.Options with { Lens = Bent, MaxOccludedFraction = 1 });

        SessionReader made = Relabel(drive.FullSession, new RelabelOptions { Lens = Bent, Roads = drive.Roads });

        Assert.Equal(
            ComparedLabels.Of(harvested, item => Unlit(ComparedLabels.WithoutOcclusion(item)), ComparedLabels.Measured, _ => false),
            ComparedLabels.Of(made, item => Unlit(ComparedLabels.WithoutOcclusion(item)), ComparedLabels.Measured, _ => false)
        );
    }

    [Fact]
    public void Relabel_through_a_lens_keeps_occlusion_of_uncropped_objects()
    {
        SessionReader made = Relabel(drive.Session, new RelabelOptions { Lens = Bent });

        foreach ((FrameLabel before, FrameLabel after) in drive.Session.ReadLabels().Zip(made.ReadLabels()))
        {
            Dictionary<int, ObjectLabel> known = before.Objects.ToDictionary(item => item.Id);
            Assert.All(
                after.Objects,
                item =>
                    Assert.Equal(
                        known.TryGetValue(item.Id, out ObjectLabel? old) && old.TruncatedFraction == 0 && item.TruncatedFraction == 0
                            ? (old.OccludedFraction, old.OcclusionMethod)
                            : (null, OcclusionMethod.None),
                        (item.OccludedFraction, item.OcclusionMethod)
                    )
            );
        }
    }

    [Fact]
    public void Relabel_through_a_lens_drops_ray_masks_but_not_imported_ones()
    {
        SessionReader made = Relabel(drive.MaskedSession, new RelabelOptions { Lens = Bent });

        Assert.All(made.ReadLabels(), label => Assert.Equal((null, null), (label.Mask, label.PixelMap)));
        Assert.All(made.ReadLabels().SelectMany(label => label.Objects), item => Assert.Null(item.Box2DVisible));
        Assert.False(Directory.Exists(made.PathOf("masks")));
        Assert.False(SessionHeader(made).GetProperty("options").GetProperty("masks").GetBoolean());

        FrameLabel label = drive.MaskedSession.ReadLabels().First();
        RecordedScene scene = SceneParser.Read(drive.MaskedSession.PathOf("scenes/00000000.json"), label);
        Assert.True(Capture.Labelling.FrameRelabeller.KeepsMask(scene, label with { PixelMap = null }, Bent));
    }

    [Fact]
    public void Relabel_with_other_faces_equals_a_harvest_with_them()
    {
        ModelFace[] moved =
        [
            .. RecordedDrive
                .Table.Faces.Where(face => face.Class == ObjectClass.Sign)
                .Select(face => face with { Name = "MOVED", FrontUpperLeft = face.FrontUpperLeft + new Vector3D(0, 0, -0.25) }),
        ];
        var table = new FaceTable(moved);
        SessionReader harvested = drive.Harvest(
            "moved",
            RecordedDrive.Options with
            {
                Faces = RecordedDrive.Table.OverriddenBy(table),
                MaxOccludedFraction = 1,
            }
        );

        SessionReader made = Relabel(drive.FullSession, new RelabelOptions { Faces = table, Roads = drive.Roads });

        Assert.Equal(ComparedLabels.Of(harvested, Blind), ComparedLabels.Of(made, Blind));
        ObjectLabel[] faces = [.. made.ReadLabels().SelectMany(label => label.Objects).Where(item => item.Name == "MOVED")];
        Assert.NotEmpty(faces);
        Assert.All(faces, face => Assert.Equal(OcclusionMethod.None, face.OcclusionMethod));

        static ObjectLabel Blind(ObjectLabel item) => item.Name == "MOVED" ? ComparedLabels.WithoutOcclusion(item) : item;
    }

    [Fact]
    public void Relabel_shows_the_sessions_markings_through_the_new_lens()
    {
        SessionReader made = Relabel(drive.FullSession, new RelabelOptions { Lens = Bent, Roads = drive.Roads });
        SessionReader other = Relabel(drive.Session, new RelabelOptions { Roads = drive.Roads, LaneWidthMetres = 3.7 });

        LaneLinePoint[] recorded = [.. drive.FullSession.ReadLabels().SelectMany(Paint)];
        Dictionary<Vector3D, Vector2D> pixels = recorded
            .DistinctBy(point => point.World)
            .ToDictionary(point => point.World, point => point.Pixel);
        LaneLinePoint[] bent = [.. made.ReadLabels().SelectMany(Paint)];
        Assert.InRange(bent.Length, recorded.Length / 2, recorded.Length);
        Assert.All(bent, point => Assert.NotEqual(pixels[point.World], point.Pixel));
        Assert.Equal(drive.Session.ReadLabels().SelectMany(Paint), other.ReadLabels().SelectMany(Paint));
    }

    [Fact]
    public void Relabel_with_other_lanes_equals_a_harvest_without_guessing()
    {
        SessionReader harvested = drive.Harvest("lanes", RecordedDrive.Options, LookAhead.OfSeconds(1), 3.7);

        SessionReader made = Relabel(
            drive.Session,
            new RelabelOptions
            {
                Roads = drive.Roads,
                LookAhead = LookAhead.OfSeconds(1),
                LaneWidthMetres = 3.7,
            }
        );

        Assert.Equal(ComparedLabels.Of(harvested, lanes: ComparedLabels.Measured), ComparedLabels.Of(made, lanes: ComparedLabels.Measured));
        Assert.NotEqual(
            ComparedLabels.Of(drive.Session, lanes: ComparedLabels.Measured),
            ComparedLabels.Of(made, lanes: ComparedLabels.Measured)
        );
        Assert.Contains(made.ReadLabels().SelectMany(Points), point => point.IsHidden is null);
        Assert.DoesNotContain(drive.Session.ReadLabels().SelectMany(Points), point => point.IsHidden is null);
    }

    [Fact]
    public void Relabel_without_roads_keeps_lanes_and_reprojects_markings()
    {
        SessionReader made = Relabel(drive.Session, new RelabelOptions { Lens = Bent });

        foreach ((FrameLabel before, FrameLabel after) in drive.Session.ReadLabels().Zip(made.ReadLabels()))
        {
            Camera camera = LabelCamera.Of(after.Camera);
            HashSet<Vector3D> places = [.. Points(before).Select(point => point.World)];
            Assert.Subset(places, Points(after).Select(point => point.World).ToHashSet());
            Assert.All(Points(after), point => Assert.True((camera.Project(point.World).Pixel - point.Pixel).Length < 0.05));
            Assert.Equal(before.Lanes?.Indicators, after.Lanes?.Indicators);
        }

        Assert.NotEmpty(made.ReadLabels().SelectMany(Points));
    }

    [Fact]
    public void Relabel_without_roads_refuses_other_lanes() =>
        Assert.Contains(
            "name a road network with --roads",
            Refused(drive.Session, new RelabelOptions { LaneWidthMetres = 3 }),
            StringComparison.Ordinal
        );

    [Fact]
    public void Relabel_refuses_a_range_that_was_not_recorded() =>
        Assert.Contains(
            "was recorded up to 150 m",
            Refused(drive.Session, new RelabelOptions { RangeMetres = 200 }),
            StringComparison.Ordinal
        );

    [Fact]
    public void Relabel_of_a_relabelled_session_is_refused()
    {
        SessionReader made = Relabel(drive.Session, new RelabelOptions { RangeMetres = 50 });

        Assert.Contains("has no scenes", Refused(made, new RelabelOptions()), StringComparison.Ordinal);
    }

    [Fact]
    public void Masks_lose_only_the_pixels_of_objects_no_longer_labelled()
    {
        SessionReader made = Relabel(
            drive.MaskedSession,
            new RelabelOptions { Classes = [ObjectClass.Pedestrian, ObjectClass.Sign, ObjectClass.TrafficLight] }
        );

        int dropped = 0;
        foreach (FrameLabel label in made.ReadLabels())
        {
            ushort[] before = PngDecoder.ReadInstanceMap(drive.MaskedSession.PathOf(label.Mask!)).Ids;
            ushort[] after = PngDecoder.ReadInstanceMap(made.PathOf(label.Mask!)).Ids;
            HashSet<int> listed = [.. label.Objects.Select(item => item.Id)];
            Assert.Equal(before.Select(id => listed.Contains(id) ? id : (ushort)0), after);
            dropped += before.Zip(after).Count(pixel => pixel.First != pixel.Second);
        }

        Assert.True(dropped > 0);
        Assert.True(SessionValidator.Validate(made).IsGood);
    }

    [Fact]
    public void Objects_keep_their_ids_and_new_ones_follow_the_largest()
    {
        SessionReader cars = drive.Harvest(
            "few",
            RecordedDrive.Options with
            {
                Classes = [ObjectClass.Bus, ObjectClass.Car],
                MinBoxAreaPixels = 400,
            }
        );

        SessionReader made = Relabel(cars, new RelabelOptions { MinBoxAreaPixels = 4, Classes = Enum.GetValues<ObjectClass>() });

        Dictionary<int, string> before = Models(cars);
        Dictionary<int, string> after = Models(made);
        Assert.All(before, item => Assert.Equal(item.Value, after[item.Key]));
        Assert.True(after.Count > before.Count);
        Assert.True(SessionValidator.Validate(made).IsGood);
    }

    [Fact]
    public void Shards_of_a_relabelling_merge_to_the_bytes_of_a_single_run()
    {
        var changes = new RelabelOptions
        {
            Roads = drive.Roads,
            LaneWidthMetres = 3.7,
            RangeMetres = 90,
            MinBoxAreaPixels = 2,
        };
        SessionReader whole = Relabel(drive.MaskedSession, changes);
        string[] parts =
        [
            .. Enumerable.Range(1, 2).Select(number => Relabel(drive.MaskedSession, changes with { Shard = new(number, 2) }).Folder),
        ];
        string merged = drive.PathOf("merged");

        Assert.Equal(RecordedDrive.Frames, SessionMerger.Merge(parts, merged, default));

        Assert.All(
            Directory.EnumerateFiles(whole.Folder, "*", SearchOption.AllDirectories),
            file => Assert.Equal(File.ReadAllBytes(file), File.ReadAllBytes(Path.Combine(merged, Path.GetRelativePath(whole.Folder, file))))
        );
    }

    private SessionReader Relabel(SessionReader session, RelabelOptions changes)
    {
        string folder = drive.PathOf(Guid.NewGuid().ToString());
        var done = new List<int>();
        new SessionRelabeller(session, changes).Run(folder, done.Add);
        Assert.Equal(changes.Shard.Count > 1 ? done.Count : RecordedDrive.Frames, done.Count);
        return new SessionReader(folder);
    }

    private string Refused(SessionReader session, RelabelOptions changes) =>
        Assert.Throws<DatasetFormatException>(() => Relabel(session, changes)).Message;

    private static System.Text.Json.JsonElement SessionHeader(SessionReader session) =>
        System.Text.Json.JsonDocument.Parse(File.ReadAllBytes(session.PathOf(SessionInfo.FileName))).RootElement;
}
