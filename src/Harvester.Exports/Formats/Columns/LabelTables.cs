namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of a session.</summary>
internal static class LabelTables
{
    /// <summary>All tables, in the order of the documentation.</summary>
    public static IReadOnlyList<LabelTable> All { get; } =
    [
        FrameTables.Frames,
        ObjectTables.Objects,
        ObjectTables.Joints,
        ObjectTables.Regions,
        LaneTables.Lanes,
        LaneTables.Indicators,
        LaneTables.Vehicles,
        LaneTables.Lines,
        LaneTables.Points,
        DriveTables.Actions,
        DriveTables.Ticks,
        DriveTables.Motion,
        FrameTables.Events,
        SensorTables.Lidar,
        SensorTables.Radar,
        SensorTables.Imu,
        SensorTables.Gnss,
        FrameTables.Pairs,
    ];
}
