using Harvester.Capture.Harvesting;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Plans;

/// <summary>How the run of a plan uses the disk.</summary>
/// <param name="Sync">When to wait for it.</param>
/// <param name="MinFreeBytes">Space that stays free, bytes; 0 watches nothing.</param>
public sealed record PlanDisk(SyncMode Sync = SyncMode.Batch, long MinFreeBytes = HarvestOptions.DefaultMinFreeBytes);
