using Harvester.Datasets.Detections;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Predictions;

/// <summary>A box that predictions are compared with.</summary>
/// <param name="Box">The box, in the pixels of the predictions.</param>
/// <param name="Label">The label of its object; null for a region without one.</param>
internal readonly record struct TruthObject(TruthBox Box, ObjectLabel? Label);
