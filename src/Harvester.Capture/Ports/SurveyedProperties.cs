namespace Harvester.Capture.Ports;

/// <summary>What the game's GET_VEHICLE_NODE_PROPERTIES says of a node.</summary>
/// <param name="Density">How dense traffic is, 0 to 15.</param>
/// <param name="Flags">The bits that the function returns.</param>
public readonly record struct SurveyedProperties(int Density, int Flags);
