namespace Harvester.Mod;

/// <summary>What a ped is to the labels.</summary>
/// <param name="Vehicle">The vehicle that it sits in or on; null on foot.</param>
/// <param name="IsLabelled">Whether it is a person who is seen: on foot, or on a two-wheeler; not the player.</param>
internal readonly record struct PedRole(int? Vehicle, bool IsLabelled);
