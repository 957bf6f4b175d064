using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Traffic;

/// <summary>How the ego has driven since somebody first asked, and where its route leads.</summary>
/// <param name="Metres">Distance driven, without repositioning.</param>
/// <param name="Collisions">Number of collisions by <see cref="EgoContact"/>.</param>
/// <param name="Contact">What the ego touches now, or null.</param>
/// <param name="RedLightsRun">Number of times that a program drove past a red light, by the car's origin.</param>
/// <param name="StopSignsRun">Number of times that a program drove past a stop sign without having stopped within 10 m of the line.</param>
/// <param name="Repositioned">Number of times that the game has put the ego elsewhere.</param>
/// <param name="Turn">How its route leaves the next junction within 80 m, or that in which it is; null without one.</param>
/// <param name="MetresToTurn">Distance to that junction, 0 in it; null without one.</param>
/// <param name="Light">The state of the light there for the ego; null if there is none, and in the junction.</param>
/// <param name="HasStopSign">Whether there is a stop sign for the ego.</param>
public sealed record EgoConduct(
    double Metres,
    IReadOnlyList<int> Collisions,
    EgoContact? Contact,
    int RedLightsRun,
    int StopSignsRun,
    int Repositioned,
    RouteTurn? Turn,
    double? MetresToTurn,
    LightState? Light,
    bool HasStopSign
);
