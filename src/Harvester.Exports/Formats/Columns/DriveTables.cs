using System.Text.Json;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of recorded drives: actions and ticks; and of recorded motion.</summary>
internal static class DriveTables
{
    private const string Controls = "-1 to 1 (steering), 0 to 1";
    private static readonly string[] OfControls = ["steering", "throttle", "brake"];
    private static readonly string[] OfCar = ["right", "forward", "up"];

    private static readonly TableField Frame = TableField.Key("frame", row => row.Frame.Frame);

    /// <summary>A row for each frame of a recorded drive.</summary>
    public static LabelTable Actions { get; } =
        new(
            "controls",
            "what the driver of a recorded drive answered to a frame",
            [
                Frame,
                TableField.Of("driver", ColumnKind.Word, "driver"),
                .. TableField.Fields("", ColumnKind.Number, "controls", Controls, OfControls),
                TableField.Of("answer_seconds", ColumnKind.Number, "answerSeconds", "s"),
                .. TableField.Fields("applied_", ColumnKind.Number, "applied", Controls, OfControls),
                TableField.Of("disturbed", ColumnKind.Truth, "disturbed"),
                TableField.Of("target_speed", ColumnKind.Number, "target.speed", "m/s"),
                TableField.Of("target_right_metres", ColumnKind.Number, "target.rightMetres", "m"),
                TableField.Of("route", ColumnKind.Word, "route"),
                TableField.Of("route_metres", ColumnKind.Number, "routeMetres", "m"),
                TableField.Of("speed", ColumnKind.Number, "speed", "m/s"),
                TableField.Axes("acceleration", "acceleration", "m/s^2, car", OfCar),
                TableField.Axes("angular_rate", "angularRate", "rad/s, car", OfCar),
                TableField.Vector(
                    [.. IndicatorTable.All.Select(indicator => "indicator_" + ColumnNames.Of(indicator.Name))],
                    "indicators",
                    "m, angle in rad"
                ),
                TableField.Of("bridge_frame", ColumnKind.Long, "bridgeFrame"),
                TableField.Of("driven_metres", ColumnKind.Number, "truth.drivenMetres", "m"),
                TableField.Of("collision", ColumnKind.Word, "truth.collision"),
                TableField.Of("outside_lanes", ColumnKind.Truth, "truth.outsideLanes"),
                TableField.Of("lane_offset_metres", ColumnKind.Number, "truth.laneOffsetMetres", "m"),
                TableField.Of("lane_angle_radians", ColumnKind.Number, "truth.laneAngleRadians", "rad"),
                TableField.Of("light", ColumnKind.Word, "truth.light"),
                TableField.Of("stop_sign", ColumnKind.Truth, "truth.stopSign"),
                .. TableField.Fields("", ColumnKind.Integer, "truth", "", "redLightsRun", "stopSignsRun", "repositioned"),
            ],
            (frame, label) => LabelTable.At(label, "drive") is { ValueKind: JsonValueKind.Object } drive ? [new TableRow(frame, drive)] : []
        );

    /// <summary>A row for each tick of a recorded drive.</summary>
    public static LabelTable Ticks { get; } =
        new(
            "drive_ticks",
            "a tick of the game from a frame to the next",
            [
                Frame,
                TableField.Key("tick", row => row.Number),
                TableField.Of("time_seconds", ColumnKind.Number, "timeSeconds", "s"),
                TableField.Of("driver", ColumnKind.Word, "driver"),
                TableField.Of("speed", ColumnKind.Number, "speed", "m/s"),
                TableField.Axes("acceleration", "acceleration", "m/s^2, car", OfCar),
                TableField.Axes("angular_rate", "angularRate", "rad/s, car", OfCar),
                .. TableField.Fields("applied_", ColumnKind.Number, "applied", Controls, OfControls),
            ],
            (frame, label) => FrameTables.Items(frame, label, "drive", "ticks")
        );

    /// <summary>A row for each tick of recorded motion.</summary>
    public static LabelTable Motion { get; } =
        new(
            "motion",
            "the ego at a tick of the game before a frame",
            [
                Frame,
                TableField.Key("tick", row => row.Number),
                TableField.Vector(
                    [
                        "time_seconds",
                        "x",
                        "y",
                        "z",
                        "right_x",
                        "right_y",
                        "right_z",
                        "forward_x",
                        "forward_y",
                        "forward_z",
                        "velocity_x",
                        "velocity_y",
                        "velocity_z",
                        "yaw_rate",
                        "acceleration",
                        "steering",
                        "throttle",
                        "brake",
                    ],
                    "",
                    "s, m, m/s, rad/s, m/s^2; world"
                ),
            ],
            (frame, label) => FrameTables.Items(frame, label, "motion")
        );
}
