namespace Harvester.Capture.Ports;

/// <summary>The result of the game's GET_VEHICLE_NODE_PROPERTIES for a node.</summary>
/// <param name="Density">Traffic density, 0 to 15.</param>
/// <param name="Flags">The bits that the function returns.</param>
public readonly record struct SurveyedProperties(int Density, int Flags);
