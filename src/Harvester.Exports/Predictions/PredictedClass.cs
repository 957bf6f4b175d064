using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Predictions;

/// <summary>A class that predictions can have.</summary>
/// <param name="Name">Name in the format of the predictions.</param>
/// <param name="Kind">The class of a session whose colour it has.</param>
public sealed record PredictedClass(string Name, ObjectClass Kind);
