using Harvester.Datasets.Detections;

namespace Harvester.Exports.Predictions;

/// <summary>A prediction of a frame and what it matches at an overlap of 0.5.</summary>
/// <param name="Box">The prediction.</param>
/// <param name="Kind">Whether it matches.</param>
/// <param name="ObjectId">Id of the object that it matches; null if it matches none.</param>
internal readonly record struct PredictionOutcome(PredictedBox Box, OutcomeKind Kind, int? ObjectId);
