namespace Harvester.Runs.Tests.Scenarios;

/// <summary>An actor as the ego sees it: along and beside the line on which the ego drove.</summary>
/// <param name="Seconds">Time since the beginning.</param>
/// <param name="Ahead">Metres from the ego's origin along its line; negative behind.</param>
/// <param name="Right">Metres to the right of the line.</param>
/// <param name="Speed">Metres per second.</param>
/// <param name="Along">The part of the velocity in the direction of the line there, m/s.</param>
/// <param name="TurnDegrees">Its direction, counter-clockwise from that of the line.</param>
/// <param name="Gap">Metres between ego and actor along the line, bumper to bumper; less than 0 beside each other.</param>
/// <param name="EgoSpeed">Speed of the ego.</param>
internal readonly record struct SeenPlace(
    double Seconds,
    double Ahead,
    double Right,
    double Speed,
    double Along,
    double TurnDegrees,
    double Gap,
    double EgoSpeed
);
