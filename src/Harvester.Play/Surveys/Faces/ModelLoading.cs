namespace Harvester.Play.Surveys.Faces;

/// <summary>The loading state of a model.</summary>
public enum ModelLoading
{
    /// <summary>The game does not have the model.</summary>
    Missing,

    /// <summary>The game is still loading the model.</summary>
    Loading,

    /// <summary>The model can be placed.</summary>
    Loaded,
}
