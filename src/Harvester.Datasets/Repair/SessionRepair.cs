namespace Harvester.Datasets.Repair;

/// <summary>What a repair recovered.</summary>
/// <param name="Frames">Frames of the new session.</param>
/// <param name="Lost">Frames of the damaged session that are not in the new one, as far as its labels and session.json tell.</param>
/// <param name="IsAllKept">Whether nothing at all was lost or made up.</param>
public sealed record SessionRepair(int Frames, int Lost, bool IsAllKept);
