using System.Text.Json;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of frames and of what is recorded with them.</summary>
internal static class FrameTables
{
    private static readonly TableField Frame = TableField.Key("frame", row => row.Frame.Frame);

    /// <summary>A row for each frame.</summary>
    public static LabelTable Frames { get; } =
        new(
            "frames",
            "a frame",
            [
                Frame,
                TableField.Given("split", row => row.Frame.Split),
                TableField.Key("session", row => row.Frame.Session),
                TableField.Given("image", row => row.Frame.Image, ColumnKind.Text),
                TableField.Of("session_frame", ColumnKind.Integer, "frame"),
                TableField.Of("session_image", ColumnKind.Text, "image"),
                TableField.Of("session_mask", ColumnKind.Text, "mask"),
                TableField.Of("moment", ColumnKind.Integer, "moment"),
                TableField.Of("view", ColumnKind.Word, "view"),
                TableField.Of("place", ColumnKind.Integer, "place"),
                TableField.Of("place_frame", ColumnKind.Integer, "placeFrame"),
                TableField.Of("game_frame", ColumnKind.Long, "gameFrame"),
                TableField.Of("time_seconds", ColumnKind.Number, "timeSeconds", "s"),
                TableField.Of("lag_frames", ColumnKind.Integer, "lagFrames"),
                TableField.Of("lag_seconds", ColumnKind.Number, "lagSeconds", "s"),
                TableField.Of("weather", ColumnKind.Word, "environment.weather"),
                TableField.Of("time_of_day", ColumnKind.Word, "environment.timeOfDay"),
                TableField.Of("width", ColumnKind.Integer, "camera.width", "px"),
                TableField.Of("height", ColumnKind.Integer, "camera.height", "px"),
                .. TableField.Fields("", ColumnKind.Number, "camera", "px, image", "fx", "fy", "cx", "cy"),
                .. TableField.Fields("", ColumnKind.Number, "camera.distortion", "", "k1", "k2", "focalScale"),
                TableField.Of("vertical_fov_degrees", ColumnKind.Number, "camera.verticalFovDegrees", "degrees"),
                TableField.Of("window_aspect", ColumnKind.Number, "camera.windowAspect"),
                TableField.Of("near_clip", ColumnKind.Number, "camera.nearClip", "m"),
                TableField.Axes("camera", "camera.position", "m, world"),
                TableField.Axes("camera_right", "camera.right", "world"),
                TableField.Axes("camera_forward", "camera.forward", "world"),
                TableField.Axes("camera_up", "camera.up", "world"),
                TableField.Of("ego_model", ColumnKind.Word, "ego.model"),
                TableField.Axes("ego", "ego.position", "m, world"),
                TableField.Of("ego_heading_degrees", ColumnKind.Number, "ego.headingDegrees", "degrees"),
                TableField.Axes("ego_right", "ego.right", "world"),
                TableField.Axes("ego_forward", "ego.forward", "world"),
                TableField.Axes("ego_up", "ego.up", "world"),
                TableField.Axes("ego_velocity", "ego.velocity", "m/s, world"),
                TableField.Of("ego_height_above_ground_metres", ColumnKind.Number, "ego.heightAboveGroundMetres", "m"),
                TableField.Of("ego_yaw_rate", ColumnKind.Number, "ego.yawRate", "rad/s"),
                TableField.Of("ego_acceleration", ColumnKind.Number, "ego.acceleration", "m/s^2"),
                .. TableField.Fields("ego_", ColumnKind.Number, "ego", "", "steering", "throttle", "brake"),
                TableField.Of("ego_manoeuvre", ColumnKind.Word, "ego.manoeuvre"),
                .. TableField.Fields(
                    "mask_",
                    ColumnKind.Integer,
                    "pixelMap",
                    "",
                    "resolutionPixels",
                    "interpolatedPixels",
                    "raysCast",
                    "pictures",
                    "undeterminedPixels"
                ),
                TableField.Of("class_map", ColumnKind.Text, "classMap.file"),
                TableField.Of("class_map_method", ColumnKind.Word, "classMap.method"),
                .. TableField.Fields("class_map_", ColumnKind.Integer, "classMap", "", "raysCast", "interpolatedPixels"),
                .. TableField.Fields("depth_", ColumnKind.Text, "depth", "", "sparse", "completed", "error"),
                .. TableField.Fields("depth_", ColumnKind.Integer, "depth", "", "raysCast", "measuredPixels"),
                TableField.Of("normals", ColumnKind.Text, "normals.file"),
                TableField.Of("normals_method", ColumnKind.Word, "normals.method"),
                TableField.Of("normals_rays_cast", ColumnKind.Integer, "normals.raysCast"),
                TableField.Of("flow_from", ColumnKind.Integer, "flow.from"),
                TableField.Of("flow_method", ColumnKind.Word, "flow.method"),
                .. TableField.Fields(
                    "flow_",
                    ColumnKind.Text,
                    "flow",
                    "",
                    "backward",
                    "forward",
                    "motion",
                    "backwardFlags",
                    "forwardFlags"
                ),
                TableField.Of("flow_error_pixels", ColumnKind.Number, "flow.errorPixels", "px"),
                TableField.Of("flow_rays_cast", ColumnKind.Integer, "flow.raysCast"),
                .. TableField.Fields("birds_eye_", ColumnKind.Text, "birdsEye", "", "file", "visible"),
                TableField.Of("birds_eye_cells", ColumnKind.Integer, "birdsEye.cells"),
                TableField.Of("birds_eye_cell_metres", ColumnKind.Number, "birdsEye.cellMetres", "m"),
                TableField.Of("birds_eye_source", ColumnKind.Word, "birdsEye.source"),
                .. TableField.Fields("occupancy_", ColumnKind.Text, "occupancy", "", "file", "instances", "visible"),
                .. TableField.Fields("occupancy_", ColumnKind.Integer, "occupancy", "", "cells", "layers"),
                .. TableField.Fields("occupancy_", ColumnKind.Number, "occupancy", "m", "cellMetres", "lowestMetres"),
                TableField.Axes("occupancy_origin", "occupancy.origin", "m, model"),
                .. TableField.Fields(
                    "rays_",
                    ColumnKind.Integer,
                    "rays",
                    "",
                    "total",
                    "map",
                    "occlusion",
                    "faces",
                    "ignoreRegions",
                    "lanes",
                    "joints",
                    "classes",
                    "depth",
                    "normals",
                    "flow"
                ),
            ],
            (frame, label) => [new TableRow(frame, label)]
        );

    /// <summary>A row for each further picture of a moment.</summary>
    public static LabelTable Pairs { get; } =
        new(
            "pairs",
            "a further picture of the moment of a frame",
            [
                Frame,
                TableField.Of("file", ColumnKind.Text, "file"),
                TableField.Of("weather", ColumnKind.Word, "weather"),
                TableField.Of("time_of_day", ColumnKind.Word, "timeOfDay"),
                TableField.Of("without", ColumnKind.Integers, "without"),
                TableField.Of("dropped", ColumnKind.Word, "dropped"),
            ],
            (frame, label) => Items(frame, label, "pairs")
        );

    /// <summary>A row for each event that is open at a frame.</summary>
    public static LabelTable Events { get; } =
        new(
            "events",
            "an event that is open at a frame",
            [
                Frame,
                TableField.Key("session", row => row.Frame.Session),
                TableField.Of("event", ColumnKind.Integer, "id"),
                TableField.Of("kind", ColumnKind.Word, "kind"),
            ],
            (frame, label) => Items(frame, label, "events")
        );

    /// <summary>The rows of the items of a list.</summary>
    public static IEnumerable<TableRow> Items(TableFrame frame, JsonElement label, params string[] path) =>
        LabelTable.List(label, path).Select((item, number) => new TableRow(frame, item) { Number = number });
}
