using System.Text.Json.Nodes;
using Harvester.Datasets.Masks;
using Harvester.Datasets.Validation;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Tests.Masks;

/// <summary>What imported maps say about the faces of signs, which they do not show apart.</summary>
public sealed class FaceImportTests : MapsOfAnotherTool
{
    [Theory]
    [InlineData(Sign, Sign, MaskNumbers.Ids)]
    [InlineData(Face, Sign, MaskNumbers.Ids)]
    [InlineData(900, 900, MaskNumbers.Overlap)]
    public void Import_gives_a_sign_its_pixels_and_shows_its_face(ushort face, ushort post, MaskNumbers numbers)
    {
        Session.AddSign(0);
        WriteMap("0.png", SceneWithSign(face, post));
        SessionReader session = Session.Open();

        MaskImport done = MaskImporter.Import(session, Maps, numbers);

        FrameLabel label = session.ReadLabels().First();
        Assert.Equal(8, done.Seen);
        Assert.Equal(SceneWithSign(Sign, Sign).Ids, MaskOf(label).Ids);
        Assert.Equal(new Box2D(15, 15, 25, 40), label.Objects[2].Box2DVisible);
        ObjectLabel part = label.Objects[3];
        Assert.Equal(
            (null, 0, 1, OcclusionMethod.Imported),
            (part.Box2DVisible, part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod)
        );
        Assert.Empty(SessionValidator.Validate(session).Problems);
    }

    [Fact]
    public void Import_hides_the_part_of_a_face_that_a_nearer_object_covers()
    {
        // The face is in columns 15 to 25; the pedestrian, 5 m away where the face is 6 m away, stands before columns 20 to 25.
        Session.AddSign(0);
        JsonObject pedestrian = Session.Pedestrian(0);
        pedestrian["box3d"]!["centre"] = new JsonArray(-2.5, 5, 1.5);
        pedestrian["box3d"]!["halfExtents"] = new JsonArray(5.0 / 6, 0, 1);
        pedestrian["box2d"] = new JsonArray(20, 15, 30, 27);
        InstanceMap map = SceneWithSign(Sign, Sign);
        Fill(map, 0, 43, 24, 46, 36);
        Fill(map, Pedestrian, 20, 15, 30, 27);
        WriteMap("0.png", map);
        SessionReader session = Session.Open();

        MaskImporter.Import(session, Maps, MaskNumbers.Ids);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((0.5, 0.5, OcclusionMethod.Imported), (part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod));
    }

    [Fact]
    public void Import_hides_a_face_whose_sign_is_invisible()
    {
        // Nothing but the post is seen.
        Session.AddSign(0);
        WriteMap("0.png", SceneWithSign(0, Sign));
        SessionReader session = Session.Open();

        Assert.Equal(7, MaskImporter.Import(session, Maps, MaskNumbers.Ids).Seen);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((1, 0, OcclusionMethod.Imported), (part.OccludedFraction, part.VisibleFraction, part.OcclusionMethod));
    }

    /// <summary>A map does not distinguish the face from the rest of its sign, which may hide it; rays do.</summary>
    [Fact]
    public void Import_keeps_ray_occlusion_of_a_face_covered_by_nothing_else()
    {
        Session.AddSign(0);
        JsonNode face = Session.Lines[0]["objects"]![3]!;
        face["occludedFraction"] = 0.7;
        face["visibleFraction"] = 0.3;
        WriteMap("0.png", SceneWithSign(Sign, Sign));
        SessionReader session = Session.Open();

        MaskImporter.Import(session, Maps, MaskNumbers.Ids);

        ObjectLabel part = session.ReadLabels().First().Objects[3];
        Assert.Equal((0.7, OcclusionMethod.Rays), (part.OccludedFraction, part.OcclusionMethod));
    }

    [Fact]
    public void Import_shows_a_face_smaller_than_a_pixel()
    {
        // 0.02 m wide at 6 m are 0.1 pixels: columns 19.95 to 20.05, between the centres of 19 and 20, which the post shows too.
        Session.AddSign(0);
        JsonNode face = Session.Lines[0]["objects"]![3]!;
        face["box3d"]!["halfExtents"] = new JsonArray(0.01, 0.005, 1);
        face["box2d"] = new JsonArray(19.95, 15, 20.05, 25);
        face["box2dAmodal"] = new JsonArray(19.95, 15, 20.05, 25);
        WriteMap("0.png", SceneWithSign(Sign, Sign));
        SessionReader session = Session.Open();

        MaskImporter.Import(session, Maps, MaskNumbers.Ids);

        Assert.Equal(0, session.ReadLabels().First().Objects[3].OccludedFraction);
    }

    // As TestSession.AddSign describes it: the face on its post, left of the others.
    private static InstanceMap SceneWithSign(ushort face, ushort post)
    {
        InstanceMap map = Scene(Car, Pedestrian);
        Fill(map, face, 15, 15, 25, 25);
        Fill(map, post, 19, 25, 21, 40);
        return map;
    }
}
