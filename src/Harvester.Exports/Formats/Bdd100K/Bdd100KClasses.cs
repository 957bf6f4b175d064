using Harvester.Geometry.Lanes;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Bdd100K;

/// <summary>The names of BDD100K; docs/exports/bdd100k.md has the tables.</summary>
internal static class Bdd100KClasses
{
    private static readonly TimeSpan DawnBegins = TimeSpan.FromHours(5);
    private static readonly TimeSpan DayBegins = TimeSpan.FromHours(7);
    private static readonly TimeSpan DuskBegins = TimeSpan.FromHours(19);
    private static readonly TimeSpan NightBegins = TimeSpan.FromHours(21);

    /// <summary>The value of what the session does not say.</summary>
    public const string Undefined = "undefined";

    /// <summary>Categories of objects: the ten that are evaluated, then those that are ignored.</summary>
    public static IReadOnlyCollection<string> Names { get; } =
    [
        "pedestrian",
        "rider",
        "car",
        "truck",
        "bus",
        "train",
        "motorcycle",
        "bicycle",
        "traffic light",
        "traffic sign",
        "other person",
        "other vehicle",
        "trailer",
    ];

    /// <summary>Categories of lane markings.</summary>
    public static IReadOnlyCollection<string> Markings { get; } = ["single white", "single yellow", "double white", "double yellow"];

    /// <summary>Values of weather.</summary>
    public static IReadOnlyCollection<string> Weathers { get; } =
    ["rainy", "snowy", "clear", "overcast", "partly cloudy", "foggy", Undefined];

    /// <summary>Values of timeofday.</summary>
    public static IReadOnlyCollection<string> Times { get; } = ["daytime", "night", "dawn/dusk", Undefined];

    /// <summary>Values of trafficLightColor.</summary>
    public static IReadOnlyCollection<string> Lights { get; } = ["red", "green", "yellow", "none"];

    /// <summary>The category of an object.</summary>
    /// <param name="kind">Its class.</param>
    /// <param name="names">Categories of classes that do not have the default.</param>
    public static string Of(ObjectClass kind, IReadOnlyDictionary<ObjectClass, string> names) =>
        names.TryGetValue(kind, out string? name)
            ? name
            : kind switch
            {
                ObjectClass.Car => "car",
                ObjectClass.Truck => "truck",
                ObjectClass.Bus => "bus",
                ObjectClass.Motorcycle => "motorcycle",
                ObjectClass.Bicycle => "bicycle",
                ObjectClass.Trailer => "trailer",
                ObjectClass.Pedestrian => "pedestrian",
                ObjectClass.Rider => "rider",
                ObjectClass.Sign => "traffic sign",
                ObjectClass.TrafficLight => "traffic light",
                _ => "other vehicle",
            };

    /// <summary>The category of a painted marking.</summary>
    public static string Of(MarkingPaint paint) =>
        (paint.Style == MarkingStyle.DoubleSolid ? "double " : "single ") + (paint.Colour == MarkingColour.Yellow ? "yellow" : "white");

    /// <summary>The weather by the game's name.</summary>
    public static string WeatherOf(string weather) =>
        weather switch
        {
            "clear" or "extrasunny" => "clear",
            "clouds" or "neutral" or "clearing" => "partly cloudy",
            "overcast" => "overcast",
            "rain" or "thunder" => "rainy",
            "snow" or "snowlight" or "blizzard" or "xmas" => "snowy",
            "foggy" or "smog" => "foggy",
            _ => Undefined,
        };

    /// <summary>The time of day by the clock.</summary>
    public static string TimeOf(TimeSpan time) =>
        time >= DayBegins && time < DuskBegins ? "daytime"
        : time >= DawnBegins && time < NightBegins ? "dawn/dusk"
        : "night";

    /// <summary>The value of trafficLightColor; none also if the state is unknown or the object is no light.</summary>
    public static string LightOf(LightState? state) =>
        state switch
        {
            LightState.Red => "red",
            LightState.Amber => "yellow",
            LightState.Green => "green",
            _ => "none",
        };
}
