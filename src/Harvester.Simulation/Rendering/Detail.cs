namespace Harvester.Simulation.Rendering;

/// <summary>How much of the light a picture shows. What is where, and how far away, is the same.</summary>
public enum Detail
{
    /// <summary>Light without shadows.</summary>
    Plain,

    /// <summary>
    /// Shadows of sun and moon, less light of the sky where something stands close by, asphalt that is worn and that mirrors in rain,
    /// tracks in lying snow, and markings that do not break into dots.
    /// </summary>
    Full,
}
