using Harvester.Geometry.Visibility;

namespace Harvester.Surveys.Faces;

/// <summary>A quiet place of a game where models are put up one at a time and measured. All calls come from the game's own thread; a failure is thrown as it is.</summary>
public interface ISurveyStage
{
    /// <summary>What rays meet.</summary>
    IRayCaster Rays { get; }

    /// <summary>Asks the game to load a model, and says how far it is; called every tick until it is loaded or not to be had.</summary>
    /// <param name="model">The model's name.</param>
    ModelLoading Load(string model);

    /// <summary>Lets the game unload a model that was asked for. Again is no harm.</summary>
    /// <param name="model">The model's name.</param>
    void Forget(string model);

    /// <summary>Puts a loaded model up where nothing else is.</summary>
    /// <param name="model">The model's name.</param>
    /// <returns>The entity's handle; 0 when the game refuses.</returns>
    int PutUp(string model);

    /// <summary>Keeps what was put up where it is.</summary>
    /// <param name="entity">The entity's handle.</param>
    void Hold(int entity);

    /// <summary>Reads a model that was put up.</summary>
    /// <param name="entity">The entity's handle.</param>
    /// <param name="model">The model's name.</param>
    StagedModel Read(int entity, string model);

    /// <summary>Whether what was put up is still there; a saved game that is loaded sweeps it away.</summary>
    /// <param name="entity">The entity's handle.</param>
    bool IsStanding(int entity);

    /// <summary>Takes an entity away that was put up. One that is gone is no harm.</summary>
    void TakeAway(int entity);
}
