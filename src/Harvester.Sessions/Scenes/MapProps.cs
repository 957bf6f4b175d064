using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Sessions.Scenes;

/// <summary>The props that say which traffic waits, by the names of the game's models.</summary>
public static class MapProps
{
    /// <summary>The posts and masts with lights for vehicles; names of the lights of railways go on differently.</summary>
    private const string Lights = "prop_traffic_0";

    private static readonly Dictionary<string, MapSignalKind> Signs = new(StringComparer.OrdinalIgnoreCase)
    {
        ["prop_sign_road_01a"] = MapSignalKind.StopSign,
        ["prop_sign_road_01b"] = MapSignalKind.StopSign,
        ["prop_sign_prologue_01a"] = MapSignalKind.StopSign,
        ["prop_snow_sign_road_01a"] = MapSignalKind.StopSign,
        ["prop_sign_road_02a"] = MapSignalKind.GiveWay,
    };

    /// <summary>Metres per second of a mile per hour.</summary>
    private const double MilesPerHour = 0.44704;

    /// <summary>The limits on the models of signs, miles per hour.</summary>
    private static readonly Dictionary<string, double> Limits = new(StringComparer.OrdinalIgnoreCase)
    {
        ["prop_sign_road_06a"] = 15,
        ["prop_sign_road_06b"] = 5,
        ["prop_sign_road_06c"] = 15,
        ["prop_sign_road_06d"] = 25,
        ["prop_sign_road_06e"] = 35,
        ["prop_sign_road_06f"] = 50,
        ["prop_sign_road_06g"] = 60,
        ["prop_sign_road_06i"] = 25,
        ["prop_sign_road_06j"] = 55,
        ["prop_sign_road_06k"] = 35,
    };

    /// <summary>What a model is; null for one that is neither a light for vehicles nor a sign to stop or to give way.</summary>
    /// <param name="model">Name of the model.</param>
    public static MapSignalKind? KindOf(string model) =>
        model is null ? throw new ArgumentNullException(nameof(model))
        : model.StartsWith(Lights, StringComparison.OrdinalIgnoreCase) ? MapSignalKind.Light
        : Signs.TryGetValue(model, out MapSignalKind kind) ? kind
        : null;

    /// <summary>A light or sign as a map has it; null for another prop. The faces of these models look towards -y of their frame.</summary>
    /// <param name="model">Name of its model.</param>
    /// <param name="pose">Where it stands.</param>
    public static MapProp? Of(string model, Pose pose) =>
        KindOf(model) is { } kind ? new MapProp(kind, model, pose.Position, -pose.Axes.Forward) : null;

    /// <summary>The lights and signs of a list, in its order.</summary>
    public static IReadOnlyList<MapProp> Of(IEnumerable<PropPlacement> props) =>
        [.. props.Select(prop => Of(prop.Name, new Pose(prop.Position, Axes.FromEuler(prop.Rotation)))).OfType<MapProp>()];

    /// <summary>The speed limit signs of a list, in its order.</summary>
    public static IReadOnlyList<MapSpeedSign> SpeedSignsOf(IEnumerable<PropPlacement> props) =>
        [
            .. props
                .Where(prop => Limits.ContainsKey(prop.Name))
                .Select(prop => new MapSpeedSign(Limits[prop.Name] * MilesPerHour, prop.Position, -Axes.FromEuler(prop.Rotation).Forward)),
        ];
}
