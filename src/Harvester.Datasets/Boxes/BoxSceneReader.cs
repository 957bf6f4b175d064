using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Datasets.Boxes;

/// <summary>Reads a scene as docs/boxes-schema.md describes it.</summary>
internal static class BoxSceneReader
{
    /// <summary>Near plane of the game, metres.</summary>
    private const double DefaultNearClip = 0.15;

    /// <summary>Allowed difference between fx or fy and the focal length from the other fields; labels have rounded values.</summary>
    private const double FocalLengthTolerancePixels = 0.01;

    /// <exception cref="DatasetFormatException">The file is not a valid scene.</exception>
    public static BoxScene Read(FileInfo file)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(file.FullName);
            return Read(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"{file.Name}: {JsonFault.InText(e)}", e);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{file.Name}: {e.Message}", e);
        }
    }

    private static BoxScene Read(JsonFields scene)
    {
        scene.AllowOnly("camera", "cuboids");
        return new BoxScene(
            ReadCamera(scene.Fields("camera")),
            [.. scene.List("cuboids").Select(cuboid => (cuboid.OptionalText("name"), ReadCuboid(cuboid)))]
        );
    }

    private static Camera ReadCamera(JsonFields camera)
    {
        camera.AllowOnly(
            "position",
            "right",
            "forward",
            "up",
            "rotation",
            "verticalFovDegrees",
            "width",
            "height",
            "windowAspect",
            "nearClip",
            "fx",
            "fy",
            "cx",
            "cy",
            "distortion"
        );
        Camera made = camera.Checked(() =>
        {
            var size = new ImageSize(camera.Integer("width"), camera.Integer("height"));
            var intrinsics = new CameraIntrinsics(
                camera.Number("verticalFovDegrees"),
                size,
                camera.OptionalNumber("windowAspect") ?? size.Aspect,
                camera.OptionalNumber("nearClip") ?? DefaultNearClip,
                ReadLens(camera, size)
            );
            return new Camera(new Pose(camera.Vector("position"), ReadAxes(camera)), intrinsics);
        });
        RequireFocalLength(camera, "fx", made.Intrinsics.Fx);
        RequireFocalLength(camera, "fy", made.Intrinsics.Fy);
        return made;
    }

    private static Lens ReadLens(JsonFields camera, ImageSize size)
    {
        double offsetX = ((camera.OptionalNumber("cx") ?? size.Width / 2.0) / size.Width) - 0.5;
        double offsetY = ((camera.OptionalNumber("cy") ?? size.Height / 2.0) / size.Height) - 0.5;
        if (!camera.Has("distortion"))
        {
            return new Lens(1, offsetX, offsetY, 0, 0);
        }

        JsonFields lens = camera.Fields("distortion");
        lens.AllowOnly("focalScale", "k1", "k2");
        return new Lens(lens.Number("focalScale"), offsetX, offsetY, lens.Number("k1"), lens.Number("k2"));
    }

    private static void RequireFocalLength(JsonFields camera, string name, double expected)
    {
        if (camera.OptionalNumber(name) is { } given && Math.Abs(given - expected) > FocalLengthTolerancePixels)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"camera.{name} is {given}, but the other fields give {expected}. Correct or remove it.")
            );
        }
    }

    private static Cuboid ReadCuboid(JsonFields cuboid)
    {
        cuboid.AllowOnly("name", "centre", "halfExtents", "position", "modelMin", "modelMax", "right", "forward", "up", "rotation");
        return cuboid.Checked(() =>
            cuboid.Has("centre")
                ? new Cuboid(cuboid.Vector("centre"), cuboid.Vector("halfExtents"), ReadAxes(cuboid))
                : Cuboid.FromModel(
                    cuboid.Vector("modelMin"),
                    cuboid.Vector("modelMax"),
                    new Pose(cuboid.Vector("position"), ReadAxes(cuboid))
                )
        );
    }

    private static Axes ReadAxes(JsonFields fields)
    {
        if (!fields.Has("rotation"))
        {
            return fields.Axes();
        }

        Vector3D angles = fields.Vector("rotation");
        return Axes.FromEuler(new EulerAngles(angles.X, angles.Y, angles.Z));
    }
}
