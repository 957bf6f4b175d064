using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>
/// Places beside a carriageway. A street is taken to have a strip for parked vehicles beside its lanes, and a pavement behind the kerb:
/// road data has neither.
/// </summary>
internal static class RoadsidePlaces
{
    /// <summary>From the edge of the lanes to the middle of a parked vehicle, metres: a strip of 2.4 m and a car near the kerb.</summary>
    private const double Parked = 1.25;

    /// <summary>From the edge of the lanes to someone on the pavement, metres.</summary>
    private const double Pavement = 3.3;

    /// <summary>Metres to the right of the ego's track where an actor at the roadside begins; null if the edge is unknown there.</summary>
    /// <exception cref="UnfitPlaceException">Another lane lies between the ego's and the roadside on the right.</exception>
    public static double? OffsetOf(StagePlace place, ScenarioStart start) =>
        start.Side > 0 && place.LaneAt(start.MetresAhead)?.RightNeighbour is not null
            ? throw new UnfitPlaceException("Another lane lies between the ego's and the roadside.")
            : OffsetOf(place, start.MetresAhead, start.Side, start.Strip);

    /// <summary>The same for any distance.</summary>
    public static double? OffsetOf(StagePlace place, double at, int side, ScenarioStrip strip) =>
        place.EdgeAt(at, side) is { } edge ? edge + (side * (strip == ScenarioStrip.Parking ? Parked : Pavement)) : null;
}
