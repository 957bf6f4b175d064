namespace Harvester.Runs.Evaluation.Figures;

/// <summary>What the game has counted since the beginning of an episode.</summary>
/// <param name="Vehicles">Collisions with vehicles in traffic.</param>
/// <param name="Parked">Collisions with parked vehicles.</param>
/// <param name="Pedestrians">Collisions with pedestrians.</param>
/// <param name="RedLights">Red lights that a program, not the built-in driver, ran.</param>
/// <param name="StopSigns">Stop signs that a program ran.</param>
public readonly record struct DriveCounters(int Vehicles, int Parked, int Pedestrians, int RedLights, int StopSigns);
