using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>
/// Reads a line of labels.jsonl, as docs/dataset-format.md describes it. Unknown fields, which later versions may add, are ignored.
/// </summary>
public static class FrameLabelParser
{
    /// <exception cref="DatasetFormatException">The line is not a valid label; the message names the field.</exception>
    public static FrameLabel Parse(string line) => Parse(line, static (label, _) => label);

    /// <summary>Reads a label, and then whatever else is wanted of its fields.</summary>
    /// <param name="line">The line.</param>
    /// <param name="read">Makes the result of the label and its fields.</param>
    /// <exception cref="DatasetFormatException">The line is not a valid label; the message names the field.</exception>
    internal static T Parse<T>(string line, Func<FrameLabel, JsonFields, T> read)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(line);
            var fields = new JsonFields(document.RootElement);
            return read(ReadFrame(fields), fields);
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InLine(e), e);
        }
    }

    private static FrameLabel ReadFrame(JsonFields frame) =>
        new(
            frame.Integer("frame"),
            frame.LongInteger("gameFrame"),
            frame.Number("timeSeconds"),
            frame.Integer("lagFrames"),
            frame.Number("lagSeconds"),
            FileNames.Picture(frame, "image"),
            frame.Has("mask") ? FileNames.Picture(frame, "mask") : null,
            ReadCamera(frame.Fields("camera")),
            ReadEgo(frame.Fields("ego")),
            ReadEnvironment(frame.Fields("environment")),
            [.. frame.List("objects").Select(ReadObject)]
        )
        {
            Moment = frame.Has("moment") ? frame.Integer("moment") : null,
            View = frame.OptionalText("view"),
            Motion = MotionParser.Parse(frame),
            Drive = DriveParser.Parse(frame),
            Events = EventParser.Marks(frame),
            Place = frame.Has("place") ? frame.Integer("place") : null,
            PlaceFrame = frame.Has("placeFrame") ? frame.Integer("placeFrame") : null,
            PixelMap = frame.Has("pixelMap") ? ReadPixelMap(frame.Fields("pixelMap")) : null,
            Channels = ReadChannels(frame),
            Rays = frame.Has("rays") ? ReadRays(frame.Fields("rays")) : null,
            IgnoreRegions = frame.Has("ignoreRegions") ? [.. frame.List("ignoreRegions").Select(ReadIgnoreRegion)] : [],
            Lanes = frame.Has("lanes") ? LanesParser.Parse(frame.Fields("lanes")) : null,
        };

    private static ChannelLabels ReadChannels(JsonFields frame)
    {
        ChannelLabels labels = ChannelLabels.None;
        foreach (FrameChannel channel in FrameChannels.All.Where(channel => frame.Has(channel.Key)))
        {
            labels = channel.Read(frame) is { } label ? labels.And(label) : labels;
        }

        return labels;
    }

    private static PixelMapLabel ReadPixelMap(JsonFields map) =>
        new(map.Integer("resolutionPixels"), map.Integer("interpolatedPixels"), map.Integer("raysCast"))
        {
            Pictures = map.Has("pictures") ? map.Integer("pictures") : null,
            UndeterminedPixels = map.Has("undeterminedPixels") ? map.Integer("undeterminedPixels") : null,
        };

    private static AmodalMask? ReadAmodalMask(JsonFields label)
    {
        AmodalMask? amodal = null;
        if (label.Has("amodalMask"))
        {
            JsonFields mask = label.Fields("amodalMask");
            int[] box = WholeNumbers(mask, "box");
            amodal =
                box.Length == 4
                    ? new AmodalMask(box[0], box[1], box[2], box[3], WholeNumbers(mask, "runs"))
                    : throw new DatasetFormatException("The box of amodalMask must have 4 numbers: left, top, width and height.");
        }

        Box2D? whole = label.Has("box2dWhole") ? ReadBox(label, "box2dWhole") : null;
        return whole == amodal?.Box ? amodal : throw new DatasetFormatException("box2dWhole must be the box of amodalMask.");
    }

    private static int[] WholeNumbers(JsonFields mask, string name) =>
        [
            .. mask.Numbers(name)
                .Select(value =>
                    value is >= 0 and <= int.MaxValue && value == Math.Floor(value)
                        ? (int)value
                        : throw new DatasetFormatException($"{name} of amodalMask must hold whole numbers of at least 0.")
                ),
        ];

    private static RayCounts ReadRays(JsonFields rays) =>
        new(
            rays.Integer("map"),
            rays.Integer("occlusion"),
            rays.Integer("faces"),
            rays.Integer("ignoreRegions"),
            rays.Integer("lanes"),
            // Sessions of earlier versions have no joints.
            rays.Has("joints")
                ? rays.Integer("joints")
                : 0
        )
        {
            Channels = FrameChannels
                .All.Select(channel => channel.RaysKey)
                .OfType<string>()
                .Where(rays.Has)
                .ToDictionary(key => key, rays.Integer),
        };

    private static CameraLabel ReadCamera(JsonFields camera)
    {
        JsonFields lens = camera.Fields("distortion");
        ImageSize size = SizeOf(camera);
        return new CameraLabel(
            new Pose(camera.Vector("position"), camera.Axes()),
            camera.Number("verticalFovDegrees"),
            size.Width,
            size.Height,
            camera.Number("windowAspect"),
            camera.Number("nearClip"),
            camera.Number("fx"),
            camera.Number("fy"),
            camera.Number("cx"),
            camera.Number("cy"),
            new DistortionLabel(lens.Number("focalScale"), lens.Number("k1"), lens.Number("k2"))
        );
    }

    private static ImageSize SizeOf(JsonFields camera)
    {
        int width = camera.Integer("width");
        int height = camera.Integer("height");
        return DeclaredSize.Problem(width, height) is { } problem
            ? throw new DatasetFormatException($"camera has {problem}.")
            : new ImageSize(width, height);
    }

    private static EgoLabel ReadEgo(JsonFields ego) =>
        new(ego.Vector("position"), ego.Number("headingDegrees"), ego.Vector("velocity"), ego.Text("model"))
        {
            Axes = ego.Has("right") ? ego.Axes() : null,
            HeightAboveGroundMetres = ego.OptionalNumber("heightAboveGroundMetres"),
            Motion = EgoMotionParser.Parse(ego),
        };

    private static EnvironmentState ReadEnvironment(JsonFields environment)
    {
        string text = environment.Text("timeOfDay");
        return TimeSpan.TryParseExact(text, @"hh\:mm\:ss", CultureInfo.InvariantCulture, out TimeSpan timeOfDay)
            ? new EnvironmentState(environment.Text("weather"), timeOfDay)
            : throw new DatasetFormatException($"environment.timeOfDay must be a time such as 13:05:00, not \"{text}\".");
    }

    private static ObjectLabel ReadObject(JsonFields label)
    {
        JsonFields box3D = label.Fields("box3d");
        return new ObjectLabel
        {
            Id = label.Integer("id"),
            Class = label.Name<ObjectClass>("class"),
            Model = label.Text("model"),
            Name = label.OptionalText("name"),
            Parent = label.Has("parent") ? label.Integer("parent") : null,
            KnownParts = label.Has("knownParts") ? label.Integer("knownParts") : null,
            HasRider = label.OptionalBoolean("hasRider"),
            Vehicle = label.Has("vehicle") ? label.Integer("vehicle") : null,
            Lights = VehicleLightsParser.Parse(label),
            Box2D = ReadBox(label, "box2d"),
            Box2DAmodal = ReadBox(label, "box2dAmodal"),
            Box2DVisible = label.Has("box2dVisible") ? ReadBox(label, "box2dVisible") : null,
            AmodalMask = ReadAmodalMask(label),
            TruncatedFraction = label.Number("truncatedFraction"),
            OccludedFraction = label.OptionalNumber("occludedFraction"),
            OcclusionMethod = label.Name<OcclusionMethod>("occlusionMethod"),
            TrueOccludedFraction = label.Has("trueOccludedFraction") ? label.Number("trueOccludedFraction") : null,
            Box3D = box3D.Checked(() => new Cuboid(box3D.Vector("centre"), box3D.Vector("halfExtents"), box3D.Axes())),
            DistanceMetres = label.Number("distanceMetres"),
            Velocity = label.Vector("velocity"),
            LaneId = label.OptionalText("laneId"),
            GovernedLanes = label.Has("governedLanes") ? label.Texts("governedLanes") : null,
            Face = label.Has("space") ? ReadFace(label.Fields("space")) : null,
            Joints = label.Has("joints") ? JointsParser.Parse(label) : null,
        };
    }

    private static IgnoreRegion ReadIgnoreRegion(JsonFields region) =>
        new(
            region.Name<IgnoreReason>("reason"),
            region.Name<ObjectClass>("class"),
            ReadBox(region, "box2d"),
            region.Number("distanceMetres")
        );

    private static FaceLabel ReadFace(JsonFields face) =>
        new(
            face.Integer("face"),
            face.OptionalText("mutcd"),
            face.Number("facingAngleDegrees"),
            face.Name<Provenance>("provenance"),
            face.Has("light") ? ReadLight(face.Fields("light")) : null
        );

    private static LightLabel ReadLight(JsonFields light) =>
        new(light.Name<LightState>("state"), light.Name<LightMethod>("method"), light.OptionalNumber("litFraction"));

    /// <summary>A list of four numbers as a box.</summary>
    internal static Box2D ReadBox(JsonFields label, string name)
    {
        double[] sides = label.Numbers(name, 4);
        return new Box2D(sides[0], sides[1], sides[2], sides[3]);
    }
}
