using System.Collections.Generic;

namespace Harvester.Datasets.Exports;

/// <summary>What of a frame is exported.</summary>
/// <param name="Objects">The objects, by rising id.</param>
/// <param name="Ignored">Regions with something that is not exported.</param>
internal sealed record FrameSelection(IReadOnlyList<ExportObject> Objects, IReadOnlyList<ExportRegion> Ignored);
