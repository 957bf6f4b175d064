using System.Text.Json;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of objects, their joints, and ignore regions.</summary>
internal static class ObjectTables
{
    private static readonly TableField Frame = TableField.Key("frame", row => row.Frame.Frame);

    /// <summary>A row for each object.</summary>
    public static LabelTable Objects { get; } =
        new(
            "objects",
            "an object in a frame",
            [
                Frame,
                TableField.Key("id", row => row.Owner, "id"),
                TableField.Given("class", row => row.Word!, field: "class"),
                TableField.Of("model", ColumnKind.Word, "model"),
                TableField.Of("name", ColumnKind.Word, "name"),
                TableField.Of("parent", ColumnKind.Integer, "parent"),
                TableField.Of("known_parts", ColumnKind.Integer, "knownParts"),
                TableField.Of("has_rider", ColumnKind.Truth, "hasRider"),
                TableField.Of("vehicle", ColumnKind.Integer, "vehicle"),
                TableField.Of("boxes", ColumnKind.Texts, "boxes"),
                TableField.Box("box2d", "box2d"),
                TableField.Box("box2d_amodal", "box2dAmodal"),
                TableField.Box("box2d_visible", "box2dVisible"),
                TableField.Box("box2d_whole", "box2dWhole"),
                TableField.Box("box2d_joints", "box2dJoints"),
                .. TableField.Fields(
                    "",
                    ColumnKind.Number,
                    "",
                    "0 to 1",
                    "truncatedFraction",
                    "occludedFraction",
                    "visibleFraction",
                    "trueOccludedFraction"
                ),
                TableField.Of("occlusion_method", ColumnKind.Word, "occlusionMethod"),
                TableField.Axes("centre", "box3d.centre", "m, world"),
                TableField.Axes("half_extents", "box3d.halfExtents", "m, object", "right", "forward", "up"),
                TableField.Axes("right", "box3d.right", "world"),
                TableField.Axes("forward", "box3d.forward", "world"),
                TableField.Axes("up", "box3d.up", "world"),
                TableField.Of("distance_metres", ColumnKind.Number, "distanceMetres", "m"),
                TableField.Axes("velocity", "velocity", "m/s, world"),
                TableField.Of("lane_id", ColumnKind.Text, "laneId"),
                TableField.Of("governed_lanes", ColumnKind.Texts, "governedLanes"),
                TableField.Of("face", ColumnKind.Integer, "space.face"),
                TableField.Of("mutcd", ColumnKind.Word, "space.mutcd"),
                TableField.Of("faces_camera", ColumnKind.Truth, "space.facesCamera"),
                TableField.Of("facing_angle_degrees", ColumnKind.Number, "space.facingAngleDegrees", "degrees"),
                TableField.Of("provenance", ColumnKind.Word, "space.provenance"),
                TableField.Of("light_state", ColumnKind.Word, "space.light.state"),
                TableField.Of("light_method", ColumnKind.Word, "space.light.method"),
                TableField.Of("light_lit_fraction", ColumnKind.Number, "space.light.litFraction", "0 to 1"),
                .. TableField.Fields("lamp_", ColumnKind.Truth, "lights", "", "brake", "left", "right", "head"),
                TableField.Of("amodal_mask_box", ColumnKind.Integers, "amodalMask.box", "px, image"),
                TableField.Of("amodal_mask_runs", ColumnKind.Integers, "amodalMask.runs", "px"),
            ],
            (frame, label) => Exported(frame, label)
        );

    /// <summary>A row for each joint of a person.</summary>
    public static LabelTable Joints { get; } =
        new(
            "joints",
            "a joint of a person",
            [
                Frame,
                TableField.Key("id", row => row.Owner),
                TableField.Of("joint", ColumnKind.Word, "joint"),
                TableField.Axes("position", "position", "m, world"),
                TableField.Vector(["u", "v"], "pixel", "px, image"),
                TableField.Of("visibility", ColumnKind.Word, "visibility"),
            ],
            (frame, label) =>
                Exported(frame, label)
                    .SelectMany(item =>
                        LabelTable.List(item.Parts[0], "joints").Select(joint => new TableRow(frame, joint) { Owner = item.Owner })
                    )
        );

    /// <summary>A row for each ignore region.</summary>
    public static LabelTable Regions { get; } =
        new(
            "ignore_regions",
            "a region that shows, or may show, an object without a label",
            [
                Frame,
                TableField.Of("reason", ColumnKind.Word, "reason"),
                TableField.Given("class", row => row.Word!, field: "class"),
                TableField.Box("box2d", "box2d"),
                TableField.Of("distance_metres", ColumnKind.Number, "distanceMetres", "m"),
            ],
            (frame, label) =>
                FrameTables
                    .Items(frame, label, "ignoreRegions")
                    .Select(row => row with { Word = frame.ClassOfRegion(LabelTable.At(row.Parts[0], "class").GetString()!) })
                    .Where(row => row.Word is not null)
        );

    private static IEnumerable<TableRow> Exported(TableFrame frame, JsonElement label)
    {
        foreach (JsonElement item in LabelTable.List(label, "objects"))
        {
            int id = item.GetProperty("id").TryGetInt32(out int known)
                ? known
                : throw new DatasetFormatException("an object has no id. Run 'harvester validate'.");
            if (frame.ClassOfObject(id) is { } kind)
            {
                yield return new TableRow(frame, item) { Owner = id, Word = kind };
            }
        }
    }
}
