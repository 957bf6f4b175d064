namespace Harvester.Runs.Evaluation.Scores;

/// <summary>Numbers of collisions by kind.</summary>
/// <param name="Vehicles">With vehicles in traffic.</param>
/// <param name="Parked">With parked vehicles.</param>
/// <param name="Pedestrians">With pedestrians.</param>
public sealed record CollisionCounts(int Vehicles, int Parked, int Pedestrians);
