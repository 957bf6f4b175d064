using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes a frame's label as one line of JSON. Fields, units and ranges: docs/dataset-format.md.</summary>
public static class JsonLabelWriter
{
    /// <summary>The line of a frame, without the end of the line.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or too large to be written.</exception>
    public static string Line(FrameLabel frame)
    {
        if (frame is null)
        {
            throw new ArgumentNullException(nameof(frame));
        }

        var json = new JsonText();
        json.BeginObject().Key("frame").Integer(frame.Frame);
        if (frame.Moment is not null)
        {
            json.Key("moment").Integer(frame.Moment).Key("view").String(frame.View);
        }

        if (frame.Place is not null)
        {
            json.Key("place").Integer(frame.Place).Key("placeFrame").Integer(frame.PlaceFrame);
        }

        json.Key("gameFrame")
            .Integer(frame.GameFrame)
            .Key("timeSeconds")
            .Number(frame.TimeSeconds, LabelDecimals.Seconds)
            .Key("lagFrames")
            .Integer(frame.LagFrames)
            .Key("lagSeconds")
            .Number(frame.LagSeconds, LabelDecimals.Seconds)
            .Key("image")
            .String(frame.Image)
            .Key("mask")
            .String(frame.Mask);
        Append(json.Key("pixelMap"), frame.PixelMap);
        Append(json, FrameChannels.Maps, frame.Channels);
        Append(json.Key("rays"), frame.Rays);
        Append(json, FrameChannels.Others, frame.Channels);
        Append(json.Key("camera"), frame.Camera);
        Append(json.Key("ego"), frame.Ego);
        MotionJson.Append(json, frame.Motion);
        DriveJson.Append(json, frame.Drive);
        EventJson.AppendMarks(json, frame.Events);
        Append(json.Key("environment"), frame.Environment);
        json.Key("objects").BeginArray();
        foreach (ObjectLabel label in frame.Objects)
        {
            Append(json, label);
        }

        json.EndArray().Key("ignoreRegions").BeginArray();
        foreach (IgnoreRegion region in frame.IgnoreRegions)
        {
            Append(json, region);
        }

        json.EndArray();
        if (frame.Lanes is { } lanes)
        {
            LanesJson.Append(json.Key("lanes"), lanes);
        }

        return json.EndObject().ToString();
    }

    /// <summary>The lanes as written in a label line.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or too large to be written.</exception>
    public static string Lanes(LanesLabel lanes)
    {
        if (lanes is null)
        {
            throw new ArgumentNullException(nameof(lanes));
        }

        var json = new JsonText();
        LanesJson.Append(json, lanes);
        return json.ToString();
    }

    internal static void Append(JsonText json, CameraLabel camera)
    {
        json.BeginObject().Key("position").Vector(camera.Pose.Position, LabelDecimals.Metres);
        Append(json, camera.Pose.Axes);
        json.Key("verticalFovDegrees")
            .Number(camera.VerticalFovDegrees, LabelDecimals.CameraRatio)
            .Key("width")
            .Integer(camera.Width)
            .Key("height")
            .Integer(camera.Height)
            .Key("windowAspect")
            .Number(camera.WindowAspect, LabelDecimals.CameraRatio)
            .Key("nearClip")
            .Number(camera.NearClip, LabelDecimals.Metres)
            .Key("fx")
            .Number(camera.Fx, LabelDecimals.Intrinsics)
            .Key("fy")
            .Number(camera.Fy, LabelDecimals.Intrinsics)
            .Key("cx")
            .Number(camera.Cx, LabelDecimals.Intrinsics)
            .Key("cy")
            .Number(camera.Cy, LabelDecimals.Intrinsics)
            .Key("distortion")
            .BeginObject()
            .Key("focalScale")
            .Number(camera.Distortion.FocalScale, LabelDecimals.CameraRatio)
            .Key("k1")
            .Number(camera.Distortion.K1, LabelDecimals.CameraRatio)
            .Key("k2")
            .Number(camera.Distortion.K2, LabelDecimals.CameraRatio)
            .EndObject()
            .EndObject();
    }

    private static void Append(JsonText json, IReadOnlyList<FrameChannel> channels, ChannelLabels labels)
    {
        foreach (FrameChannel channel in channels)
        {
            if (channel.LabelIn(labels) is { } label)
            {
                channel.Append(json.Key(channel.Key), label);
            }
        }
    }

    private static void Append(JsonText json, PixelMapLabel? map)
    {
        if (map is null)
        {
            json.String(null);
            return;
        }

        json.BeginObject()
            .Key("resolutionPixels")
            .Integer(map.ResolutionPixels)
            .Key("interpolatedPixels")
            .Integer(map.InterpolatedPixels)
            .Key("raysCast")
            .Integer(map.RaysCast);
        if (map.Pictures is not null)
        {
            json.Key("pictures").Integer(map.Pictures).Key("undeterminedPixels").Integer(map.UndeterminedPixels);
        }

        json.EndObject();
    }

    private static void Append(JsonText json, AmodalMask mask)
    {
        json.BeginObject()
            .Key("box")
            .BeginArray()
            .Integer(mask.Left)
            .Integer(mask.Top)
            .Integer(mask.Width)
            .Integer(mask.Height)
            .EndArray()
            .Key("runs")
            .BeginArray();
        foreach (int run in mask.Runs)
        {
            json.Integer(run);
        }

        json.EndArray().EndObject();
    }

    private static void Append(JsonText json, RayCounts? rays)
    {
        if (rays is null)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("total")
            .Integer(rays.Total)
            .Key("map")
            .Integer(rays.Map)
            .Key("occlusion")
            .Integer(rays.Occlusion)
            .Key("faces")
            .Integer(rays.Faces)
            .Key("ignoreRegions")
            .Integer(rays.IgnoreRegions)
            .Key("lanes")
            .Integer(rays.Lanes)
            .Key("joints")
            .Integer(rays.Joints);
        foreach (string key in FrameChannels.All.Select(channel => channel.RaysKey).OfType<string>().Where(key => rays.Of(key) > 0))
        {
            json.Key(key).Integer(rays.Of(key));
        }

        json.EndObject();
    }

    private static void Append(JsonText json, EgoLabel ego)
    {
        json.BeginObject()
            .Key("position")
            .Vector(ego.Position, LabelDecimals.Metres)
            .Key("headingDegrees")
            .Number(RoundedHeading(ego.HeadingDegrees), LabelDecimals.Degrees);
        if (ego.Axes is { } axes)
        {
            Append(json, axes);
        }

        json.Key("heightAboveGroundMetres")
            .Number(ego.HeightAboveGroundMetres, LabelDecimals.Metres)
            .Key("velocity")
            .Vector(ego.Velocity, LabelDecimals.Speed)
            .Key("model")
            .String(ego.Model);
        if (ego.Motion is { } motion)
        {
            EgoMotionJson.Append(json, motion);
        }

        json.EndObject();
    }

    /// <summary>The heading in [0, 360) also after rounding: 359.99999 is written as 0.</summary>
    private static double RoundedHeading(double headingDegrees)
    {
        const double steps = 10_000;
        return Angles.WrapHeadingDegrees(Math.Floor((headingDegrees * steps) + 0.5) / steps);
    }

    private static void Append(JsonText json, EnvironmentState environment) =>
        json.BeginObject()
            .Key("weather")
            .String(environment.Weather)
            .Key("timeOfDay")
            .String(environment.TimeOfDay.ToString("hh\\:mm\\:ss", CultureInfo.InvariantCulture))
            .EndObject();

    private static void Append(JsonText json, ObjectLabel label)
    {
        json.BeginObject()
            .Key("id")
            .Integer(label.Id)
            .Key("class")
            .String(JsonName.Of(label.Class))
            .Key("model")
            .String(label.Model)
            .Key("name")
            .String(label.Name)
            .Key("parent")
            .Integer(label.Parent)
            .Key("knownParts")
            .Integer(label.KnownParts)
            .Key("hasRider")
            .Boolean(label.HasRider);
        if (label.Class == ObjectClass.Rider)
        {
            json.Key("vehicle").Integer(label.Vehicle);
        }

        json.Key("box2d")
            .Box(label.Box2D, LabelDecimals.Pixels)
            .Key("box2dAmodal")
            .Box(label.Box2DAmodal, LabelDecimals.Pixels)
            .Key("box2dVisible")
            .Box(label.Box2DVisible, LabelDecimals.Pixels);
        if (label.Box2DWhole is { } whole)
        {
            json.Key("box2dWhole").Box(whole, LabelDecimals.Pixels);
        }

        json.Key("boxes").BeginArray();
        foreach (BoxKind kind in label.Boxes)
        {
            json.String(JsonName.Of(kind));
        }

        json.EndArray()
            .Key("truncatedFraction")
            .Number(label.TruncatedFraction, LabelDecimals.Fraction)
            .Key("occludedFraction")
            .Number(label.OccludedFraction, LabelDecimals.Fraction)
            .Key("occlusionMethod")
            .String(JsonName.Of(label.OcclusionMethod))
            .Key("visibleFraction")
            .Number(label.VisibleFraction, LabelDecimals.Fraction);
        if (label.TrueOccludedFraction is { } hidden)
        {
            json.Key("trueOccludedFraction").Number(hidden, LabelDecimals.Fraction);
        }

        Append(json.Key("box3d"), label.Box3D);
        json.Key("distanceMetres")
            .Number(label.DistanceMetres, LabelDecimals.Metres)
            .Key("velocity")
            .Vector(label.Velocity, LabelDecimals.Speed);
        if (label.LaneId is { } lane)
        {
            json.Key("laneId").String(lane);
        }

        if (label.GovernedLanes is { } governed)
        {
            json.Key("governedLanes").BeginArray();
            foreach (string each in governed)
            {
                json.String(each);
            }

            json.EndArray();
        }

        if (label.AmodalMask is { } amodal)
        {
            Append(json.Key("amodalMask"), amodal);
        }

        Append(json.Key("space"), label.Face);
        VehicleLightsJson.Append(json, label.Lights);
        if (label.Joints is { } joints)
        {
            JointsJson.Append(json, joints);
        }

        json.EndObject();
    }

    private static void Append(JsonText json, IgnoreRegion region) =>
        json.BeginObject()
            .Key("reason")
            .String(JsonName.Of(region.Reason))
            .Key("class")
            .String(JsonName.Of(region.Class))
            .Key("box2d")
            .Box(region.Box2D, LabelDecimals.Pixels)
            .Key("distanceMetres")
            .Number(region.DistanceMetres, LabelDecimals.Metres)
            .EndObject();

    private static void Append(JsonText json, FaceLabel? face)
    {
        if (face is null)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("face")
            .Integer(face.Number)
            .Key("mutcd")
            .String(face.MutcdCode)
            .Key("facesCamera")
            .Boolean(face.FacesCamera)
            .Key("facingAngleDegrees")
            .Number(face.FacingAngleDegrees, LabelDecimals.Degrees)
            .Key("provenance")
            .String(JsonName.Of(face.Provenance));
        json.Key("light");
        if (face.Light is { } light)
        {
            json.BeginObject()
                .Key("state")
                .String(JsonName.Of(light.State))
                .Key("method")
                .String(JsonName.Of(light.Method))
                .Key("litFraction")
                .Number(light.LitFraction, LabelDecimals.Fraction)
                .EndObject();
        }
        else
        {
            json.Null();
        }

        json.EndObject();
    }

    private static void Append(JsonText json, Cuboid cuboid)
    {
        json.BeginObject()
            .Key("centre")
            .Vector(cuboid.Centre, LabelDecimals.Metres)
            .Key("halfExtents")
            .Vector(cuboid.HalfExtents, LabelDecimals.Metres);
        Append(json, cuboid.Axes);
        json.EndObject();
    }

    private static void Append(JsonText json, Axes axes) =>
        json.Key("right")
            .Vector(axes.Right, LabelDecimals.Axis)
            .Key("forward")
            .Vector(axes.Forward, LabelDecimals.Axis)
            .Key("up")
            .Vector(axes.Up, LabelDecimals.Axis);
}
