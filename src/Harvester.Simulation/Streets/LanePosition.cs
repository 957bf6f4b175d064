namespace Harvester.Simulation.Streets;

/// <summary>A body's position among the lanes of the simulated world. Right and left are as seen in the driving direction.</summary>
/// <param name="Road">Number of the road.</param>
/// <param name="AlongRoad">Whether the body faces along the road's line; otherwise against it. This is the driving direction.</param>
/// <param name="DistanceAlongRoad">Metres from the road's start.</param>
/// <param name="RightOfRoadLine">Metres to the right of the line through the road's nodes.</param>
/// <param name="Lane">Number of the lane from the left of the driving direction; null on an oncoming lane, a median, or in a junction
/// outside all lanes.</param>
/// <param name="Lanes">Lanes of the driving direction.</param>
/// <param name="OncomingLanes">Lanes of the other direction.</param>
/// <param name="LaneWidth">Metres.</param>
/// <param name="MedianWidth">Metres between the directions.</param>
/// <param name="RightOfLaneCentre">Metres to the right of the centre of the lane on which the body is, whichever its direction; 0 on a
/// median.</param>
/// <param name="AngleToRoad">Angle from the body's direction to the road's, radians; positive if the body points to the right of the
/// road.</param>
/// <param name="Curvature">Curvature of the road's line, 1/m, positive in a bend to the left.</param>
/// <param name="IsInJunction">Whether carriageways overlap here, so that no lines are painted.</param>
public sealed record LanePosition(
    int Road,
    bool AlongRoad,
    double DistanceAlongRoad,
    double RightOfRoadLine,
    int? Lane,
    int Lanes,
    int OncomingLanes,
    double LaneWidth,
    double MedianWidth,
    double RightOfLaneCentre,
    double AngleToRoad,
    double Curvature,
    bool IsInJunction
);
