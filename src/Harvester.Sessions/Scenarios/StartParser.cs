using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>Reads where an actor begins.</summary>
internal static class StartParser
{
    private const double Farthest = 300;
    private const double World = 20_000;
    private static readonly (string Field, ScenarioPlaceKind Kind)[] Kinds =
    [
        ("approach", ScenarioPlaceKind.Junction),
        ("roadside", ScenarioPlaceKind.Roadside),
        ("crossing", ScenarioPlaceKind.Crossing),
        ("x", ScenarioPlaceKind.Point),
    ];

    public static ScenarioStart Read(CheckedJson start)
    {
        (string field, ScenarioPlaceKind kind) = Kinds.FirstOrDefault(each => start.Has(each.Field));
        var made = new ScenarioStart(field is null ? ScenarioPlaceKind.Lane : kind)
        {
            MetresRight = start.Number("metresRight", -50, 50, 0),
        };
        made = made.Kind switch
        {
            ScenarioPlaceKind.Junction => Before(start, made),
            ScenarioPlaceKind.Roadside => made with
            {
                Strip = start.Choice<ScenarioStrip>("roadside"),
                Side = SideOf(start, "side"),
                MetresAhead = start.Number("metresAhead", -Farthest, Farthest),
                HeadingDegrees = HeadingOf(start, 0),
            },
            ScenarioPlaceKind.Crossing => made with { Side = SideOf(start, "crossing"), HeadingDegrees = HeadingOf(start, 0) },
            ScenarioPlaceKind.Point => made with
            {
                Point = new Vector2D(start.Number("x", -World, World), start.Number("y", -World, World)),
                HeadingDegrees = start.Number("headingDegrees", -360, 360),
            },
            _ => made with
            {
                MetresAhead = start.Number("metresAhead", -Farthest, Farthest),
                Lane = start.Choice("lane", ScenarioLane.Ego),
                HeadingDegrees = HeadingOf(start, 0),
            },
        };
        return ScenarioParser.Ended(start, made);
    }

    /// <summary>A side by name, right if it is not given: -1 left, 1 right.</summary>
    public static int SideOf(CheckedJson fields, string name) =>
        fields.Text(name, "right") switch
        {
            "left" => -1,
            "right" => 1,
            _ => throw fields.Wrong(name, "left or right"),
        };

    private static ScenarioStart Before(CheckedJson start, ScenarioStart made) =>
        start.Has("metresBefore") == start.Has("secondsBefore")
            ? throw start.Wrong("metresBefore", "given, or secondsBefore instead")
            : made with
            {
                Approach = start.Choice<ScenarioApproach>("approach"),
                MetresBefore = start.Has("metresBefore") ? start.Number("metresBefore", 0, Farthest) : null,
                SecondsBefore = start.Has("secondsBefore") ? start.Number("secondsBefore", -20, 20) : null,
            };

    private static double HeadingOf(CheckedJson start, double otherwise) =>
        !start.Has("heading")
            ? start.Number("headingDegrees", -360, 360, otherwise)
            : start.Text("heading") switch
            {
                "same" => 0,
                "opposite" => 180,
                _ => throw start.Wrong("heading", "same or opposite; other directions are headingDegrees"),
            };
}
