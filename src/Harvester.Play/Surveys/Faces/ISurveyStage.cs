using Harvester.Geometry.Visibility;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// A free place in a game where models are placed one at a time and measured. All calls come from the game's own thread; exceptions of the
/// game are passed on.
/// </summary>
public interface ISurveyStage
{
    /// <summary>Casts rays at the placed model.</summary>
    IRayCaster Rays { get; }

    /// <summary>Asks the game to load a model, and returns its loading state; called every tick until it is loaded or missing.</summary>
    /// <param name="model">The name of the model in the game.</param>
    ModelLoading Load(string model);

    /// <summary>Lets the game unload a model that was requested. Further calls do nothing.</summary>
    /// <param name="model">The name of the model in the game.</param>
    void Release(string model);

    /// <summary>Places a loaded model where nothing else is.</summary>
    /// <param name="model">The name of the model in the game.</param>
    /// <returns>The entity's handle; 0 if the game refuses.</returns>
    int PutUp(string model);

    /// <summary>Fixes a placed entity in its position.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    void Hold(int entity);

    /// <summary>Reads a placed model.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    /// <param name="model">The name of the model in the game.</param>
    StagedModel Read(int entity, string model);

    /// <summary>Whether a placed entity still exists; loading a saved game removes it.</summary>
    /// <param name="entity">Handle of the placed entity.</param>
    bool IsStanding(int entity);

    /// <summary>Removes a placed entity. It need not exist any more.</summary>
    void TakeAway(int entity);
}
