namespace Harvester.Simulation.Rendering;

/// <summary>How much of the light a picture shows. What is where, and how far away, is the same.</summary>
public enum Detail
{
    /// <summary>Light without shadows.</summary>
    Plain,

    /// <summary>Shadows of sun and moon, and less light of the sky where something stands close by.</summary>
    Full,
}
