namespace Harvester.Surveys.Faces;

/// <summary>How far the loading of a model is.</summary>
public enum ModelLoading
{
    /// <summary>The game does not have the model.</summary>
    Missing,

    /// <summary>Not there yet.</summary>
    Loading,

    /// <summary>It can be put up.</summary>
    Loaded,
}
