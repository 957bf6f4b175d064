using System.Net;

namespace Harvester.Cli.Driving;

/// <summary>Over what a drive goes, and which side of it this process is.</summary>
/// <param name="Kind">The bridge.</param>
/// <param name="Role">Which sides.</param>
/// <param name="Folder">The shared folder of a folder bridge.</param>
/// <param name="At">Where a socket bridge listens or is reached; null for a free port of this machine, or the usual one.</param>
/// <param name="Token">What a peer shows; null for none.</param>
internal sealed record BridgePlan(BridgeName Kind, DriveRole Role, string Folder, IPEndPoint? At, string? Token);
