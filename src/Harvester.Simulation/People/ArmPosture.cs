namespace Harvester.Simulation.People;

/// <summary>The angles of an arm, radians.</summary>
/// <param name="Swing">Of the upper arm forward from hanging down.</param>
/// <param name="Aside">Of the upper arm away from the body.</param>
/// <param name="Bend">Of the elbow, 0 for a straight arm.</param>
/// <param name="Inward">Of the forearm towards the other side.</param>
internal readonly record struct ArmPosture(double Swing, double Aside, double Bend, double Inward = 0);
