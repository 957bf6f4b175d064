using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Labels;

public sealed class JsonLabelWriterTests
{
    [Fact]
    public void Line_has_the_documented_fields_in_their_order()
    {
        string expected =
            """{"frame":3,"gameFrame":120,"timeSeconds":1.983333,"lagFrames":0,"lagSeconds":0,"image":"frames/00000003.png","mask":null"""
            + ""","pixelMap":null,"rays":{"total":231,"map":0,"occlusion":130,"faces":64,"ignoreRegions":17,"lanes":20,"joints":0},"""
            + """ "camera":{"position":[1,-2.5,3],"right":[1,0,0],"forward":[0,1,0],"up":[0,0,1],"verticalFovDegrees":50""".TrimStart()
            + ""","width":800,"height":600,"windowAspect":1.777777778,"nearClip":0.15,"fx":482.507,"fy":643.352076,"cx":400,"cy":300"""
            + ""","distortion":{"focalScale":1.008,"k1":-0.02,"k2":0}},"""
            + """ "ego":{"position":[1,-4,0],"headingDegrees":0,"right":[1,0,0],"forward":[0,1,0],"up":[0,0,1]""".TrimStart()
            + ""","heightAboveGroundMetres":0.51,"velocity":[0,15.25,0],"model":"blista"}"""
            + ""","environment":{"weather":"clear","timeOfDay":"07:05:09"},"""
            + """ "objects":[{"id":1,"class":"trafficLight","model":"prop_traffic_01a","name":"light \"A\"","parent":9""".TrimStart()
            + ""","knownParts":null,"hasRider":null,"box2d":[0,10.5,20.125,30],"box2dAmodal":[-5.25,10.5,20.125,30]"""
            + ""","box2dVisible":[0,11,20,30],"boxes":["cuboid","amodal","visible"],"truncatedFraction":0.25,"occludedFraction":0.5"""
            + ""","occlusionMethod":"rays","visibleFraction":0.375,"""
            + """ "box3d":{"centre":[10,20,0.5],"halfExtents":[1,2,0.5],"right":[1,0,0],"forward":[0,1,0],"up":[0,0,1]}""".TrimStart()
            + ""","distanceMetres":24.3567,"velocity":[0,0,0],"space":{"face":1,"mutcd":null,"facesCamera":true"""
            + ""","facingAngleDegrees":12.3457"""
            + ""","provenance":"derived","light":{"state":"amber","method":"observed","litFraction":0.0813}}},"""
            + """ {"id":2,"class":"motorcycle","model":"bati","name":null,"parent":null,"knownParts":0,"hasRider":true""".TrimStart()
            + ""","box2d":[1,2,3,4],"box2dAmodal":[1,2,3,4],"box2dVisible":null,"boxes":["cuboid","amodal"],"truncatedFraction":0"""
            + ""","occludedFraction":null,"occlusionMethod":"none","visibleFraction":null,"""
            + """ "box3d":{"centre":[10,20,0.5],"halfExtents":[1,2,0.5],"right":[1,0,0],"forward":[0,1,0],"up":[0,0,1]}""".TrimStart()
            + ""","distanceMetres":5,"velocity":[0,0,0],"space":null}]"""
            + ""","ignoreRegions":[{"reason":"beyondRange","class":"truck","box2d":[700.5,290,720.125,305],"distanceMetres":157.2346}]}""";

        Assert.Equal(expected, JsonLabelWriter.Line(Frame()));
    }

    [Fact]
    public void Line_with_a_mask_has_its_quality()
    {
        string line = JsonLabelWriter.Line(Frame() with { Mask = "masks/00000003.png", PixelMap = new PixelMapLabel(4, 1200, 350) });

        Assert.Contains(
            "\"mask\":\"masks/00000003.png\",\"pixelMap\":{\"resolutionPixels\":4,\"interpolatedPixels\":1200,\"raysCast\":350},\"rays\":",
            line,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Line_heading_just_below_360_is_written_as_0()
    {
        // 359.99999 has four decimals 360, which is no heading.
        FrameLabel frame = Frame();
        string line = JsonLabelWriter.Line(frame with { Ego = frame.Ego with { HeadingDegrees = 359.99999 } });

        Assert.Contains("\"headingDegrees\":0,", line, StringComparison.Ordinal);
    }

    [Fact]
    public void Line_refuses_a_number_that_is_not_finite()
    {
        FrameLabel frame = Frame();

        Assert.Throws<ArgumentOutOfRangeException>(() => JsonLabelWriter.Line(frame with { TimeSeconds = double.NaN }));
    }

    private static FrameLabel Frame()
    {
        var camera = new CameraLabel(
            new Pose(new Vector3D(1, -2.5, 3), Axes.Identity),
            50,
            800,
            600,
            16.0 / 9,
            0.15,
            482.507,
            643.3520764,
            400,
            300,
            new DistortionLabel(1.008, -0.02, 0)
        );
        var light = new ObjectLabel
        {
            Id = 1,
            Class = ObjectClass.TrafficLight,
            Model = "prop_traffic_01a",
            Name = "light \"A\"",
            Parent = 9,
            Face = new FaceLabel(1, null, 12.34567, Provenance.Derived, new LightLabel(LightState.Amber, LightMethod.Observed, 0.08125)),
            Box2D = new Box2D(0, 10.5, 20.125, 30),
            Box2DAmodal = new Box2D(-5.25, 10.5, 20.125, 30),
            Box2DVisible = new Box2D(0, 11, 20, 30),
            TruncatedFraction = 0.25,
            OccludedFraction = 0.5,
            OcclusionMethod = OcclusionMethod.Rays,
            Box3D = new Cuboid(new Vector3D(10, 20, 0.5), new Vector3D(1, 2, 0.5), Axes.Identity),
            DistanceMetres = 24.35672,
            Velocity = new Vector3D(0, -0.00001, 0),
        };
        ObjectLabel motorcycle = light with
        {
            Id = 2,
            Class = ObjectClass.Motorcycle,
            Model = "bati",
            Name = null,
            Parent = null,
            KnownParts = 0,
            HasRider = true,
            Face = null,
            Box2D = new Box2D(1, 2, 3, 4),
            Box2DAmodal = new Box2D(1, 2, 3, 4),
            Box2DVisible = null,
            TruncatedFraction = 0,
            OccludedFraction = null,
            OcclusionMethod = OcclusionMethod.None,
            DistanceMetres = 5,
        };
        return new FrameLabel(
            3,
            120,
            119 / 60.0,
            0,
            0,
            "frames/00000003.png",
            null,
            camera,
            new EgoLabel(new Vector3D(1, -4, 0), 0, new Vector3D(0, 15.25, 0), "blista")
            {
                Axes = Axes.Identity,
                HeightAboveGroundMetres = 0.51,
            },
            new EnvironmentState("clear", new TimeSpan(7, 5, 9)),
            [light, motorcycle]
        )
        {
            Rays = new RayCounts(0, 130, 64, 17, 20, 0),
            IgnoreRegions = [new IgnoreRegion(IgnoreReason.BeyondRange, ObjectClass.Truck, new Box2D(700.5, 290, 720.125, 305), 157.23456)],
        };
    }
}
