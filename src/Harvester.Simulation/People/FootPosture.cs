namespace Harvester.Simulation.People;

/// <summary>Where a foot is, in the model's frame.</summary>
/// <param name="Forward">Of the ankle, metres.</param>
/// <param name="Height">Of the ankle above the ground, metres.</param>
/// <param name="Pitch">Of the foot, toes up positive, radians.</param>
/// <param name="Spread">Of the ankle outward from below the hip, metres.</param>
internal readonly record struct FootPosture(double Forward, double Height, double Pitch, double Spread = 0);
